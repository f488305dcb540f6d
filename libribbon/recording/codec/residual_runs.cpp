#include "recording/codec/residual_runs.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

constexpr std::array<std::size_t, 4> packed_bytes = {0, block_rows / 4, block_rows / 2, block_rows};

// Low bits are read and written in words that reach beyond them.
constexpr std::size_t word_bytes = sizeof(std::uint64_t);

[[gnu::always_inline]] inline unsigned char mode_of(const std::uint32_t* block) {
  std::uint32_t any = 0;
  for (std::size_t k = 0; k < block_rows; ++k) any |= block[k];
  const auto width = static_cast<int>(std::bit_width(any));
  if (width <= 4) return width == 0 ? zeros : width <= 2 ? quads : pairs;
  return static_cast<unsigned char>(bytes + std::max(width - 8, 0));
}

// Symbols of so many bits, the first in the lowest bits of a byte.
template <unsigned bits>
[[gnu::always_inline]] inline void pack_block(const std::uint32_t* from, unsigned low,
                                              unsigned char* to) {
  constexpr unsigned in_a_byte = 8 / bits;
  for (unsigned byte = 0; byte < block_rows / in_a_byte; ++byte) {
    std::uint32_t symbols = 0;
    for (unsigned k = 0; k < in_a_byte; ++k)
      symbols |= from[byte * in_a_byte + k] >> low << bits * k;
    to[byte] = static_cast<unsigned char>(symbols);
  }
}

template <unsigned bits>
[[gnu::always_inline]] inline void unpack_block(const unsigned char* from, std::uint32_t* to) {
  std::uint64_t symbols = 0;
  std::memcpy(&symbols, from, block_rows * bits / 8);
  RIBBON_EACH_LANE_OF_A_FEW
  for (unsigned k = 0; k < block_rows; ++k)
    to[k] = static_cast<std::uint32_t>(symbols >> bits * k) & ((1U << bits) - 1);
}

template <>
[[gnu::always_inline]] inline void unpack_block<8>(const unsigned char* from, std::uint32_t* to) {
  RIBBON_EACH_LANE_OF_A_FEW
  for (std::size_t k = 0; k < block_rows; ++k) to[k] = from[k];
}

// `count` bits each, one directly beside the other, from the lowest bit of each byte on.
[[gnu::always_inline]] inline void put_low_bits(const std::uint32_t* block, unsigned count,
                                                unsigned char* to) {
  const std::uint32_t mask = (std::uint32_t{1} << count) - 1;
  std::memset(to, 0, block_rows * count / 8);
  for (std::size_t k = 0; k < block_rows; ++k) {
    std::uint64_t word = 0;
    unsigned char* at = to + k * count / 8;
    std::memcpy(&word, at, word_bytes);
    word |= std::uint64_t{block[k] & mask} << k * count % 8;
    std::memcpy(at, &word, word_bytes);
  }
}

// `rows` of them at a time, which a word holds.
template <unsigned rows>
[[gnu::always_inline]] inline void add_low_bits(const unsigned char* from, unsigned count,
                                                std::uint32_t* to) {
  const std::uint32_t mask = (std::uint32_t{1} << count) - 1;
  for (unsigned first = 0; first < block_rows; first += rows) {
    std::uint64_t word = 0;
    std::memcpy(&word, from + first * count / 8, word_bytes);
    word >>= first * count % 8;
    RIBBON_EACH_LANE_OF_A_FEW
    for (unsigned k = 0; k < rows; ++k)
      to[first + k] =
          to[first + k] << count | (static_cast<std::uint32_t>(word >> k * count) & mask);
  }
}

// Where the next block's bytes are, in each run.
struct Places {
  unsigned char* quad;
  unsigned char* pair;
  unsigned char* byte;
  unsigned char* low;

  explicit Places(ResidualRuns& runs)
      : quad(runs.packed[quads].data()),
        pair(runs.packed[pairs].data()),
        byte(runs.packed[bytes].data()),
        low(runs.low_bits.data()) {}
};

// Visits all blocks with their place in each run: visit(mode, number of the block, places); what a
// block takes is then behind them.
template <class Visit>
[[gnu::always_inline]] inline void for_each_block(ResidualRuns& runs, const Visit& visit) {
  Places at(runs);
  for (std::size_t block = 0; block < runs.modes.size(); ++block) {
    const unsigned mode = runs.modes[block];
    visit(mode, block * block_rows, at);
    if (mode == quads) at.quad += packed_bytes[quads];
    if (mode == pairs) at.pair += packed_bytes[pairs];
    if (mode < bytes) continue;
    at.byte += packed_bytes[bytes];
    at.low += (mode - bytes) * block_rows / 8;
  }
}

}  // namespace

Residuals::Residuals(const RibbonGrid& grid)
    : column_length_((static_cast<std::size_t>(grid.along) + block_rows - 1) / block_rows *
                     block_rows),
      columns_(static_cast<std::size_t>(grid.across)),
      numbers_(3 * columns_ * column_length_) {}

bool ResidualRuns::resize() {
  std::array<std::size_t, bytes + 1> blocks{};
  bool are_known = true;
  vectorised([&]() RIBBON_INLINED {
    std::uint32_t of_quads = 0;
    std::uint32_t of_pairs = 0;
    std::uint32_t of_bytes = 0;
    std::uint32_t low = 0;  // bits of one row
    unsigned char highest = 0;
    for (const unsigned char mode : modes) {
      highest = std::max(highest, mode);
      of_quads += mode == quads ? 1 : 0;
      of_pairs += mode == pairs ? 1 : 0;
      of_bytes += mode >= bytes ? 1 : 0;
      low += mode >= bytes ? mode - bytes : 0;
    }
    blocks = {0, of_quads, of_pairs, of_bytes};
    low_bytes = std::size_t{low} * block_rows / 8;
    are_known = highest <= bytes + most_low_bits;
  });
  if (!are_known) return false;
  for (const PackingMode run : {quads, pairs, bytes})
    packed[run].resize(packed_bytes[run] * blocks[run]);
  low_bits.resize(low_bytes + word_bytes);
  return true;
}

void ResidualPacker::append(const Residuals& residuals, std::string& to) {
  const std::uint32_t* numbers = residuals.numbers().data();
  runs_.modes.resize(residuals.block_count());
  vectorised([&]() RIBBON_INLINED {
    for (std::size_t block = 0; block < runs_.modes.size(); ++block)
      runs_.modes[block] = mode_of(numbers + block * block_rows);
  });
  runs_.resize();
  vectorised([&]() RIBBON_INLINED {
    for_each_block(runs_, [&](unsigned mode, std::size_t first, const Places& at) RIBBON_INLINED {
      const std::uint32_t* block = numbers + first;
      if (mode == quads) pack_block<2>(block, 0, at.quad);
      if (mode == pairs) pack_block<4>(block, 0, at.pair);
      if (mode >= bytes) pack_block<8>(block, mode - bytes, at.byte);
      if (mode > bytes) put_low_bits(block, mode - bytes, at.low);
    });
  });
  compressor_.append(runs_.modes, to);
  for (const auto& run : runs_.packed) compressor_.append(run, to);
  to.append(runs_.low_bits.begin(),
            runs_.low_bits.begin() + static_cast<std::ptrdiff_t>(runs_.low_bytes));
}

bool ResidualUnpacker::unpack(std::string_view from, Residuals& residuals) {
  runs_.modes.resize(residuals.block_count());
  if (!decompressor_.take(from, runs_.modes) || !runs_.resize()) return false;
  for (auto& run : runs_.packed)
    if (!decompressor_.take(from, run)) return false;
  if (from.size() != runs_.low_bytes) return false;
  std::copy(from.begin(), from.end(), runs_.low_bits.begin());
  std::uint32_t* numbers = residuals.numbers().data();
  vectorised([&]() RIBBON_INLINED {
    for_each_block(runs_, [&](unsigned mode, std::size_t first, const Places& at) RIBBON_INLINED {
      std::uint32_t* block = numbers + first;
      if (mode == zeros) std::fill_n(block, block_rows, 0U);
      if (mode == quads) unpack_block<2>(at.quad, block);
      if (mode == pairs) unpack_block<4>(at.pair, block);
      if (mode >= bytes) unpack_block<8>(at.byte, block);
      if (mode > bytes) {
        constexpr unsigned most_of_four = 15;  // and 4 bits where they begin within a byte
        if (mode - bytes <= most_of_four)
          add_low_bits<4>(at.low, mode - bytes, block);
        else
          add_low_bits<2>(at.low, mode - bytes, block);
      }
    });
  });
  return true;
}

}  // namespace ribbon

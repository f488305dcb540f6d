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

[[gnu::always_inline]] inline unsigned char mode_of(const std::int32_t* block) {
  std::int32_t any = 0;  // 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
  for (std::size_t k = 0; k < block_rows; ++k) any |= block[k] << 1 ^ block[k] >> 31;
  const unsigned width = std::bit_width(static_cast<std::uint32_t>(any));
  if (width <= 4) return width == 0 ? zeros : width <= 2 ? quads : pairs;
  const unsigned low = std::max(width, 8U) - 8;
  return static_cast<unsigned char>(bytes + (low <= 8 ? low : 8 + std::bit_width((low - 9) | 1U)));
}

[[gnu::always_inline]] inline unsigned low_bits_of(unsigned mode) {
  const unsigned low = mode - bytes;
  return low <= 8 ? low : 8 + (2U << (low - 9));
}

// Symbols of so many bits, the first in the lowest bits of a byte.
template <unsigned bits>
[[gnu::always_inline]] inline void pack_block(const std::int32_t* from, unsigned low,
                                              unsigned char* to) {
  constexpr unsigned in_a_byte = 8 / bits;
  for (unsigned byte = 0; byte < block_rows / in_a_byte; ++byte) {
    unsigned symbols = 0;
    for (unsigned k = 0; k < in_a_byte; ++k)
      symbols |= (static_cast<unsigned>(from[byte * in_a_byte + k] >> low) & ((1U << bits) - 1))
                 << bits * k;
    to[byte] = static_cast<unsigned char>(symbols);
  }
}

template <unsigned bits>
[[gnu::always_inline]] inline void unpack_block(const unsigned char* from, std::int32_t* to) {
  constexpr unsigned in_a_word = 32 / bits;
  for (unsigned first = 0; first < block_rows; first += in_a_word) {
    std::uint32_t word = 0;
    std::memcpy(&word, from + first * bits / 8, sizeof(word));
    RIBBON_EACH_LANE_OF_A_FEW
    for (unsigned k = 0; k < in_a_word; ++k)
      to[first + k] = static_cast<std::int32_t>(word << (32 - bits - bits * k)) >> (32 - bits);
  }
}

template <>
[[gnu::always_inline]] inline void unpack_block<8>(const unsigned char* from, std::int32_t* to) {
  RIBBON_EACH_LANE_OF_A_FEW
  for (std::size_t k = 0; k < block_rows; ++k) to[k] = (from[k] ^ 0x80) - 0x80;
}

// `count` bits each, one directly beside the other, from the lowest bit of each byte on.
[[gnu::always_inline]] inline void put_low_bits(const std::int32_t* block, unsigned count,
                                                unsigned char* to) {
  const std::uint32_t mask = (std::uint32_t{1} << count) - 1;
  std::memset(to, 0, block_rows * count / 8);
  for (std::size_t k = 0; k < block_rows; ++k) {
    std::uint64_t word = 0;
    unsigned char* at = to + k * count / 8;
    std::memcpy(&word, at, word_bytes);
    word |= std::uint64_t{static_cast<std::uint32_t>(block[k]) & mask} << k * count % 8;
    std::memcpy(at, &word, word_bytes);
  }
}

// `rows` of them at a time, which a word holds.
template <unsigned rows>
[[gnu::always_inline]] inline void add_low_bits(const unsigned char* from, unsigned count,
                                                std::int32_t* to) {
  const std::uint32_t mask = (std::uint32_t{1} << count) - 1;
  for (unsigned first = 0; first < block_rows; first += rows) {
    std::uint64_t word = 0;
    std::memcpy(&word, from + first * count / 8, word_bytes);
    word >>= first * count % 8;
    RIBBON_EACH_LANE_OF_A_FEW
    for (unsigned k = 0; k < rows; ++k)
      to[first + k] =
          static_cast<std::int32_t>(static_cast<std::uint32_t>(to[first + k]) << count |
                                    (static_cast<std::uint32_t>(word >> k * count) & mask));
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
    at.low += low_bits_of(mode) * block_rows / 8;
  }
}

}  // namespace

Residuals::Residuals(const RibbonGrid& grid)
    : column_length_((static_cast<std::size_t>(grid.along) + block_rows - 1) / block_rows *
                     block_rows),
      columns_(static_cast<std::size_t>(grid.across)),
      numbers_(3 * columns_ * column_length_) {}

void ResidualRuns::resize() {
  std::array<std::size_t, bytes + 1> blocks{};
  vectorised([&]() RIBBON_INLINED {
    std::uint32_t of_quads = 0;
    std::uint32_t of_pairs = 0;
    std::uint32_t of_bytes = 0;
    std::uint32_t low = 0;  // bits of one row
    for (const unsigned char mode : modes) {
      of_quads += mode == quads ? 1 : 0;
      of_pairs += mode == pairs ? 1 : 0;
      of_bytes += mode >= bytes ? 1 : 0;
      low += mode >= bytes ? low_bits_of(mode) : 0;
    }
    blocks = {0, of_quads, of_pairs, of_bytes};
    low_bytes = std::size_t{low} * block_rows / 8;
  });
  for (const PackingMode run : {quads, pairs, bytes})
    packed[run].resize(packed_bytes[run] * blocks[run]);
  low_bits.resize(low_bytes + word_bytes);
}

void ResidualPacker::append(const Residuals& residuals, std::string& to) {
  const std::int32_t* numbers = residuals.numbers().data();
  std::vector<unsigned char>& modes = runs_.modes;
  modes.resize(residuals.block_count());
  vectorised([&]() RIBBON_INLINED {
    for (std::size_t block = 0; block < modes.size(); ++block)
      modes[block] = mode_of(numbers + block * block_rows);
  });
  runs_.resize();
  std::vector<unsigned char>& two_modes = runs_.packed[zeros];
  two_modes.assign((modes.size() + 1) / 2, 0);
  for (std::size_t block = 0; block < modes.size(); ++block)
    two_modes[block / 2] |= static_cast<unsigned char>(modes[block] << 4 * (block % 2));
  vectorised([&]() RIBBON_INLINED {
    for_each_block(runs_, [&](unsigned mode, std::size_t first, const Places& at) RIBBON_INLINED {
      const std::int32_t* block = numbers + first;
      if (mode == quads) pack_block<2>(block, 0, at.quad);
      if (mode == pairs) pack_block<4>(block, 0, at.pair);
      if (mode >= bytes) pack_block<8>(block, low_bits_of(mode), at.byte);
      if (mode > bytes) put_low_bits(block, low_bits_of(mode), at.low);
    });
  });
  for (std::size_t run = 0; run < runs_.packed.size(); ++run)
    compressor_.append(run, runs_.packed[run], to);
  to.append(runs_.low_bits.begin(),
            runs_.low_bits.begin() + static_cast<std::ptrdiff_t>(runs_.low_bytes));
}

bool ResidualUnpacker::unpack(std::string_view from, Residuals& residuals) {
  std::vector<unsigned char>& modes = runs_.modes;
  std::vector<unsigned char>& two_modes = runs_.packed[zeros];
  two_modes.resize((residuals.block_count() + 1) / 2);
  if (!decompressor_.take(zeros, from, two_modes)) return false;
  modes.resize(2 * two_modes.size());
  vectorised([&]() RIBBON_INLINED {
    const unsigned char* two = two_modes.data();
    unsigned char* one = modes.data();
    const std::size_t count = two_modes.size();
    RIBBON_EACH_LANE
    for (std::size_t k = 0; k < count; ++k) {
      one[2 * k] = two[k] & 0xF;
      one[2 * k + 1] = two[k] >> 4;
    }
  });
  modes.resize(residuals.block_count());
  runs_.resize();
  for (const PackingMode run : {quads, pairs, bytes})
    if (!decompressor_.take(run, from, runs_.packed[run])) return false;
  if (from.size() != runs_.low_bytes) return false;
  std::copy(from.begin(), from.end(), runs_.low_bits.begin());
  std::int32_t* numbers = residuals.numbers().data();
  vectorised([&]() RIBBON_INLINED {
    for_each_block(runs_, [&](unsigned mode, std::size_t first, const Places& at) RIBBON_INLINED {
      std::int32_t* block = numbers + first;
      if (mode == zeros) std::fill_n(block, block_rows, 0);
      if (mode == quads) unpack_block<2>(at.quad, block);
      if (mode == pairs) unpack_block<4>(at.pair, block);
      if (mode >= bytes) unpack_block<8>(at.byte, block);
      if (mode > bytes) {
        constexpr unsigned most_of_four = 15;  // and 4 bits where they begin within a byte
        const unsigned count = low_bits_of(mode);
        if (count <= most_of_four)
          add_low_bits<4>(at.low, count, block);
        else
          add_low_bits<2>(at.low, count, block);
      }
    });
  });
  return true;
}

}  // namespace ribbon

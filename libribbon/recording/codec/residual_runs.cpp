#include "recording/codec/residual_runs.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

// How a block is packed: not at all, because all are 0; in two bits each; or in four and some low
// planes: there are modes from `fours` on for 0 to 10, 13, 19 and 28 of these, sixteen modes in
// all.
enum Mode : unsigned { zeros = 0, twos = 1, fours = 2 };

// Kinds of symbols, as SymbolCompressor knows them.
enum Kind : std::size_t { pairs_of_modes = 0, quads = 1, pairs = 2 };

constexpr std::size_t quads_of_block = block_rows / 4;
constexpr std::size_t pairs_of_block = block_rows / 2;

using Sixteen = std::int32_t __attribute__((vector_size(sizeof(std::int32_t) * block_rows)));

[[gnu::always_inline]] inline unsigned planes_of(unsigned mode) {
  const unsigned k = mode - fours;
  return mode <= fours ? 0 : k <= 10 ? k : k == 11 ? 13 : k == 12 ? 19 : 28;
}

[[gnu::always_inline]] inline unsigned char mode_of(const std::int32_t* block) {
  std::int32_t any = 0;  // 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
  for (std::size_t k = 0; k < block_rows; ++k) any |= block[k] << 1 ^ block[k] >> 31;
  const unsigned width = std::bit_width(static_cast<std::uint32_t>(any));
  if (width <= 2) return width == 0 ? zeros : twos;
  const unsigned low = std::max(width, 4U) - 4;
  return static_cast<unsigned char>(fours + (low <= 10   ? low
                                             : low <= 13 ? 11
                                             : low <= 19 ? 12
                                                         : 13));
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

// Low planes, the highest first.
[[gnu::always_inline]] inline void put_planes(const std::int32_t* block, unsigned count,
                                              std::uint16_t* to) {
  while (count-- > 0) {
    unsigned plane = 0;
    for (unsigned k = 0; k < block_rows; ++k)
      plane |= (static_cast<unsigned>(block[k]) >> count & 1) << k;
    *to++ = static_cast<std::uint16_t>(plane);
  }
}

[[gnu::always_inline]] inline void add_planes(const std::uint16_t* from, unsigned count,
                                              std::int32_t* block) {
  constexpr Sixteen lane = {1 << 0, 1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                            1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
  Sixteen numbers;
  std::memcpy(&numbers, block, sizeof(numbers));
  for (; count > 0; --count, ++from) numbers = numbers + numbers - ((lane & *from) != 0);
  std::memcpy(block, &numbers, sizeof(numbers));
}

// Visits all blocks: visit(mode, number of the first residual, where the block's symbols and planes
// begin).
template <class Visit>
[[gnu::always_inline]] inline void for_each_block(ResidualRuns& runs, const Visit& visit) {
  unsigned char* quad = runs.packed[quads].data();
  unsigned char* pair = runs.packed[pairs].data();
  std::uint16_t* plane = runs.planes.data();
  for (std::size_t block = 0; block < runs.modes.size(); ++block) {
    const unsigned mode = runs.modes[block];
    visit(mode, block * block_rows, mode == twos ? quad : pair, plane);
    if (mode == twos) quad += quads_of_block;
    if (mode < fours) continue;
    pair += pairs_of_block;
    plane += planes_of(mode);
  }
}

}  // namespace

void ResidualRuns::resize() {
  std::array<std::size_t, 3> sizes{};
  vectorised([&]() RIBBON_INLINED {
    std::uint32_t of_twos = 0;
    std::uint32_t of_fours = 0;
    std::uint32_t low = 0;
    for (const unsigned char mode : modes) {
      of_twos += mode == twos ? 1 : 0;
      of_fours += mode >= fours ? 1 : 0;
      low += planes_of(mode);
    }
    sizes = {of_twos * quads_of_block, of_fours * pairs_of_block, low};
  });
  packed[quads].resize(sizes[0]);
  packed[pairs].resize(sizes[1]);
  planes.resize(sizes[2]);
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
  std::vector<unsigned char>& two_modes = runs_.packed[pairs_of_modes];
  two_modes.assign((modes.size() + 1) / 2, 0);
  for (std::size_t block = 0; block < modes.size(); ++block)
    two_modes[block / 2] |= static_cast<unsigned char>(modes[block] << 4 * (block % 2));
  vectorised([&]() RIBBON_INLINED {
    for_each_block(runs_, [&](unsigned mode, std::size_t first, unsigned char* symbols,
                              std::uint16_t* planes) RIBBON_INLINED {
      if (mode == twos) pack_block<2>(numbers + first, 0, symbols);
      if (mode < fours) return;
      pack_block<4>(numbers + first, planes_of(mode), symbols);
      put_planes(numbers + first, planes_of(mode), planes);
    });
  });
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind)
    compressor_.append(kind, runs_.packed[kind], to);
  to.append(reinterpret_cast<const char*>(runs_.planes.data()), 2 * runs_.planes.size());
}

bool ResidualUnpacker::unpack(ByteTaker& taker, Residuals& residuals) {
  std::vector<unsigned char>& modes = runs_.modes;
  std::vector<unsigned char>& two_modes = runs_.packed[pairs_of_modes];
  two_modes.resize((residuals.block_count() + 1) / 2);
  if (!decompressor_.take(pairs_of_modes, taker, two_modes)) return false;
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
  for (const Kind kind : {quads, pairs})
    if (!decompressor_.take(kind, taker, runs_.packed[kind])) return false;
  if (!taker.complete() || taker.rest().size() != 2 * runs_.planes.size()) return false;
  std::copy(taker.rest().begin(), taker.rest().end(), reinterpret_cast<char*>(runs_.planes.data()));
  std::int32_t* numbers = residuals.numbers().data();
  vectorised([&]() RIBBON_INLINED {
    for_each_block(runs_, [&](unsigned mode, std::size_t first, const unsigned char* symbols,
                              const std::uint16_t* planes) RIBBON_INLINED {
      std::int32_t* block = numbers + first;
      if (mode == zeros) std::fill_n(block, block_rows, 0);
      if (mode == twos) unpack_block<2>(symbols, block);
      if (mode < fours) return;
      unpack_block<4>(symbols, block);
      if (mode > fours) add_planes(planes, planes_of(mode), block);
    });
  });
  return true;
}

}  // namespace ribbon

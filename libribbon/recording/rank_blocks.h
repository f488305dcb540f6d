// Ranks as bytes: blocks of particles, each written in the form that suits it (FORMAT.md, section
// 8.4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recording/compression.h"
#include "recording/parity_planes.h"

namespace ribbon {

// Of each component as many ranks as there are particles, in the order of the planes; behind them
// there is room for one more row quantum.
using Ranks = std::array<std::vector<std::uint32_t>, 3>;
inline std::size_t room_for_ranks(const RibbonGrid& grid) {
  return static_cast<std::size_t>(grid.particle_count()) + ParityPlanes::row_quantum;
}

// Kinds of runs of symbols: the forms of the blocks, and one for each of seven forms.
inline constexpr std::size_t form_kind = 0;
inline constexpr std::size_t symbol_kinds = 8;

// Symbol runs as they are before entropy coding, by kind.
using SymbolRuns = std::array<std::string, symbol_kinds>;

// Keep their memory between calls and nothing else.
class RankPacker {
 public:
  RankPacker(const ParityPlanes& planes, std::span<const std::string> entropy_tables)
      : planes_(planes), compressor_(entropy_tables) {}

  // Appends the ranks to `bytes`, to be followed by nothing else.
  void append(const Ranks& ranks, std::string& bytes);

  // The runs of the last call, from which entropy tables can be made.
  [[nodiscard]] const SymbolRuns& runs() const { return runs_; }

 private:
  ParityPlanes planes_;
  SymbolCompressor compressor_;
  SymbolRuns runs_;
};

class RankUnpacker {
 public:
  RankUnpacker(const ParityPlanes& planes, std::span<const std::string> entropy_tables);

  // False where `bytes` do not hold exactly the ranks of a frame.
  bool unpack(std::string_view bytes, Ranks& ranks);

 private:
  bool take_forms(std::string_view& bytes);
  bool take_symbols(std::string_view& bytes);

  ParityPlanes planes_;
  SymbolDecompressor decompressor_;
  std::vector<std::size_t> block_sizes_;  // of one component
  std::vector<unsigned char> forms_;      // of all components
  std::array<std::vector<unsigned char>, symbol_kinds> symbols_;
};

}  // namespace ribbon

// Ranks as bytes: blocks of particles, each written in the form that suits it (FORMAT.md, section
// 8.6).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recording/codec/parity_planes.h"
#include "recording/coding/compression.h"

namespace ribbon {

using Ranks = PlaneFields<std::uint32_t>;

// Particles whose ranks are written in one form: a stretch of up to four columns of a plane.
struct RankBlock {
  std::size_t cell = 0;  // its first one
  std::size_t columns = 0;
  std::size_t length = 0;  // particles of each column

  [[nodiscard]] std::size_t particles() const { return columns * length; }
};

// The blocks of a component, in their order.
std::vector<RankBlock> rank_blocks(const ParityPlanes& planes);

// Kinds of runs of symbols: the forms of the blocks, and one for each of seven forms.
inline constexpr std::size_t form_kind = 0;
inline constexpr std::size_t symbol_kinds = 8;

// All bytes that a run of this kind can hold.
std::vector<unsigned char> symbols_of(std::size_t kind);

// Symbol runs as they are before entropy coding, by kind.
using SymbolRuns = std::array<std::string, symbol_kinds>;

// Keep their memory between calls and nothing else.
class RankPacker {
 public:
  RankPacker(const ParityPlanes& planes, std::span<const std::string> entropy_tables)
      : stride_(static_cast<std::size_t>(planes.stride())),
        blocks_(rank_blocks(planes)),
        compressor_(entropy_tables) {}

  // Appends the ranks to `bytes`, to be followed by nothing else.
  void append(const Ranks& ranks, std::string& bytes);

  // The runs of the last call, from which entropy tables can be made.
  [[nodiscard]] const SymbolRuns& runs() const { return runs_; }

 private:
  std::size_t stride_;
  std::vector<RankBlock> blocks_;
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
  bool spread_symbols(std::string_view& bytes, Ranks& ranks) const;
  bool add_low_bits(std::string_view bytes, Ranks& ranks) const;

  std::size_t cells_;
  std::size_t stride_;
  SymbolDecompressor decompressor_;
  std::vector<RankBlock> blocks_;     // of one component
  std::vector<unsigned char> forms_;  // of all components
  std::array<std::vector<unsigned char>, symbol_kinds> symbols_;
};

}  // namespace ribbon

// Residuals as bytes: blocks of particles, each written in the coding mode that suits it
// (FORMAT.md, section 8.6).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recording/codec/polyphase_planes.h"
#include "recording/coding/compression.h"

namespace ribbon {

using Residuals = PlaneFields<std::uint32_t>;

// Particles whose residuals are written in one coding mode: a stretch of up to four columns of a
// plane.
struct ResidualBlock {
  std::size_t cell = 0;  // its first one
  std::size_t columns = 0;
  std::size_t length = 0;  // particles of each column

  [[nodiscard]] std::size_t particles() const { return columns * length; }
};

// The blocks of a component, in their order.
std::vector<ResidualBlock> residual_blocks(const PolyphasePlanes& planes);

// Kinds of runs of symbols: the coding modes of the blocks, and one for each of seven modes.
inline constexpr std::size_t mode_kind = 0;
inline constexpr std::size_t symbol_kinds = 8;

// All bytes that a run of this kind can hold.
std::vector<unsigned char> symbols_of(std::size_t kind);

// Symbol runs as they are before entropy coding, by kind.
using SymbolRuns = std::array<std::string, symbol_kinds>;

// Keep their memory between calls and nothing else.
class ResidualPacker {
 public:
  ResidualPacker(const PolyphasePlanes& planes, std::span<const std::string> entropy_tables)
      : stride_(planes.stride()), blocks_(residual_blocks(planes)), compressor_(entropy_tables) {}

  // Appends the residuals to `bytes`, to be followed by nothing else.
  void append(const Residuals& residuals, std::string& bytes);

  // The runs of the last call, from which entropy tables can be made.
  [[nodiscard]] const SymbolRuns& runs() const { return runs_; }

 private:
  std::size_t stride_;
  std::vector<ResidualBlock> blocks_;
  SymbolCompressor compressor_;
  SymbolRuns runs_;
};

class ResidualUnpacker {
 public:
  ResidualUnpacker(const PolyphasePlanes& planes, std::span<const std::string> entropy_tables);

  // False where `bytes` do not hold exactly the residuals of a frame.
  bool unpack(std::string_view bytes, Residuals& residuals);

 private:
  bool take_modes(std::string_view& bytes);
  bool take_symbols(std::string_view& bytes);
  bool spread_symbols(std::string_view& bytes, Residuals& residuals) const;
  bool add_low_bits(std::string_view bytes, Residuals& residuals) const;

  std::size_t cells_;
  std::size_t stride_;
  SymbolDecompressor decompressor_;
  std::vector<ResidualBlock> blocks_;  // of one component
  std::vector<unsigned char> modes_;   // of all components
  std::array<std::vector<unsigned char>, symbol_kinds> symbols_;
};

}  // namespace ribbon

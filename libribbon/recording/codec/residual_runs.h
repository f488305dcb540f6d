// Residuals as bytes: blocks of sixteen, each packed as its largest one allows (FORMAT.md,
// section 8.5).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/ribbon_grid.h"
#include "recording/codec/particle_columns.h"
#include "recording/coding/compression.h"

namespace ribbon {

inline constexpr std::size_t block_rows = 16;

// Of all particles: x, y, then z; column by column, each filled up to whole blocks. What fills it
// up is 0 wherever residuals are packed.
class Residuals {
 public:
  explicit Residuals(const RibbonGrid& grid)
      : column_length_((grid.along + block_rows - 1) / block_rows * block_rows),
        columns_(grid.across),
        numbers_(3 * columns_ * column_length_) {}

  [[nodiscard]] std::int32_t* column(std::size_t c, int j) {
    return numbers_.data() + column_length_ * (c * columns_ + static_cast<std::size_t>(j));
  }
  [[nodiscard]] const Lines<std::int32_t>& numbers() const { return numbers_; }
  [[nodiscard]] Lines<std::int32_t>& numbers() { return numbers_; }
  [[nodiscard]] std::size_t block_count() const { return numbers_.size() / block_rows; }

 private:
  std::size_t column_length_;
  std::size_t columns_;  // of one component
  Lines<std::int32_t> numbers_;
};

// What blocks become before entropy coding.
struct ResidualRuns {
  std::vector<unsigned char> modes;  // of blocks
  // The modes, two in a byte; residuals of small ones, four in a byte; of larger ones, two in a
  // byte, without their lowest bits, which are the low planes: a bit of each of a block's
  // residuals.
  std::array<std::vector<unsigned char>, symbol_kinds> packed;
  std::vector<std::uint16_t> planes;

  // Makes room for what the modes ask for.
  void resize();
};

// Keeps its memory between calls and nothing else.
class ResidualPacker {
 public:
  // Appends the residuals to `to`, to be followed by nothing else.
  void append(const Residuals& residuals, std::string& to);

 private:
  SymbolCompressor compressor_;
  ResidualRuns runs_;
};

class ResidualUnpacker {
 public:
  // False where the rest is not exactly the residuals of a frame.
  bool unpack(ByteTaker& taker, Residuals& residuals);

 private:
  SymbolDecompressor decompressor_;
  ResidualRuns runs_;
};

}  // namespace ribbon

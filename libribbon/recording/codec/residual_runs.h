// Residuals as bytes: blocks of sixteen, each packed as its largest one allows (FORMAT.md,
// section 8.5).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
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
  explicit Residuals(const RibbonGrid& grid);

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

// How a block is packed: not at all, because all are 0; four or two in a byte; one in a byte
// without its lowest bits, which follow elsewhere: there are modes from `bytes` on for 0 to 8, 10,
// 12, 16 and 24 of these, sixteen modes in all.
enum PackingMode : std::uint8_t { zeros = 0, quads = 1, pairs = 2, bytes = 3 };

// What blocks become before entropy coding.
struct ResidualRuns {
  std::vector<unsigned char> modes;
  // Of quads, pairs and bytes: `packed[mode]`. Instead of zeros: the modes, two in a byte.
  std::array<std::vector<unsigned char>, 4> packed;
  std::vector<unsigned char> low_bits;  // and some bytes more, which are nobody's
  std::size_t low_bytes = 0;            // without these

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
  // False where `from` does not hold exactly the residuals of a frame.
  bool unpack(std::string_view from, Residuals& residuals);

 private:
  SymbolDecompressor decompressor_;
  ResidualRuns runs_;
};

}  // namespace ribbon

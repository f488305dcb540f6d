// Which parts of a picture have anything to show.
#pragma once

#include <cstdint>
#include <vector>

#include "player/picture/picture.h"
#include "player/render/surface.h"
#include "player/view/camera.h"

namespace ribbon {

// A picture cut into square tiles, row by row from the top left; the last ones may be cut off.
class TileCoverage {
 public:
  TileCoverage(Camera camera, PictureSize size, int tile_side);

  // Marks every tile that a sample of `surface` can fall into, and perhaps some more.
  void mark(const Surface& surface);
  void mark_all();

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] bool covered(int column, int row) const {
    return covered_[static_cast<std::size_t>(row) * columns_ + column] != 0;
  }

 private:
  void mark_box(const Eigen::Vector2f& low, const Eigen::Vector2f& high);

  Camera camera_;
  PictureSize size_;
  int tile_side_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> covered_;
};

}  // namespace ribbon

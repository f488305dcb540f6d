// The particles of a ribbon, column by column (FORMAT.md, section 8.2).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// Columns come one behind the other, for ribbons are much longer than wide: what is predicted from
// the column before is predicted side by side along the ribbon. A border of one row and one column
// gives every particle all its neighbours.
class ParticleColumns {
 public:
  explicit ParticleColumns(const RibbonGrid& grid)
      : grid_(grid), stride_(static_cast<std::size_t>(grid.along) + 2) {}

  [[nodiscard]] const RibbonGrid& grid() const { return grid_; }
  // From a cell to its neighbour in the next column.
  [[nodiscard]] std::size_t stride() const { return stride_; }
  // Of all columns with their borders.
  [[nodiscard]] std::size_t cells() const {
    return stride_ * (static_cast<std::size_t>(grid_.across) + 2);
  }
  // Of particle (i, j); i from -1 to along, j from -1 to across: the border.
  [[nodiscard]] std::size_t cell(int i, int j) const {
    return stride_ * static_cast<std::size_t>(j + 1) + static_cast<std::size_t>(i + 1);
  }

 private:
  RibbonGrid grid_;
  std::size_t stride_;
};

// x, y and z.
template <class T>
using Triple = std::array<T, 3>;

// A value for each cell, of x, y and z.
using CellValues = Triple<std::vector<float>>;

}  // namespace ribbon

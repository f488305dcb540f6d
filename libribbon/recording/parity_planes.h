// The particles of a ribbon in four planes, by the parity of row and column (FORMAT.md, section
// 8.2).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// Particle (i, j) lies in plane 2 (i mod 2) + (j mod 2), row i div 2, column j div 2. All planes
// have the same size and a border, so that the neighbours of a whole plane lie at
// constant distances in other planes: what is predicted from them is predicted side by side.
class ParityPlanes {
 public:
  static constexpr int count = 4;
  // Rows have room for a multiple of so many particles, and their border.
  static constexpr int row_quantum = 8;

  explicit ParityPlanes(const RibbonGrid& grid)
      : grid_(grid),
        stride_(((grid.across + 1) / 2 + row_quantum - 1) / row_quantum * row_quantum + 2),
        plane_cells_(static_cast<std::size_t>(((grid.along + 1) / 2 + 4) * stride_)) {}

  [[nodiscard]] const RibbonGrid& grid() const { return grid_; }
  // Cells of all planes with their borders.
  [[nodiscard]] std::size_t cells() const { return count * plane_cells_ + row_quantum; }
  [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }

  // Rows and columns of a plane that hold particles.
  [[nodiscard]] int rows(int plane) const { return (grid_.along + 1 - plane / 2) / 2; }
  [[nodiscard]] int columns(int plane) const { return (grid_.across + 1 - plane % 2) / 2; }
  [[nodiscard]] std::size_t particles(int plane) const {
    return static_cast<std::size_t>(rows(plane)) * static_cast<std::size_t>(columns(plane));
  }

  // The cell of row a and column b of a plane; its border is two rows and one column wide.
  [[nodiscard]] std::size_t cell(int plane, int a, int b) const {
    return static_cast<std::size_t>(plane) * plane_cells_ +
           static_cast<std::size_t>((a + 2) * stride_ + b + 1);
  }
  // The cell of particle (i, j); i from -1 to along, j from -1 to across: the border of the ribbon.
  [[nodiscard]] std::size_t cell_of(int i, int j) const {
    return cell(2 * (i & 1) + (j & 1), i >> 1, j >> 1);
  }
  // From a cell of `plane` to the cell of its neighbour `di` rows and `dj` columns away in the
  // ribbon.
  [[nodiscard]] std::ptrdiff_t step(int plane, int di, int dj) const {
    const int i = plane / 2 + di + 2;
    const int j = plane % 2 + dj + 2;
    return static_cast<std::ptrdiff_t>(cell_of(i, j)) -
           static_cast<std::ptrdiff_t>(cell(plane, 1, 1));
  }

 private:
  RibbonGrid grid_;
  int stride_;
  std::size_t plane_cells_;
};

// One number for each cell, for x, y and z.
template <class Number>
using PlaneFields = std::array<std::vector<Number>, 3>;

}  // namespace ribbon

// The particles of a ribbon in four planes, by the parity of row and column (FORMAT.md, section
// 8.2).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// Particle (i, j) lies in plane 2 (i mod 2) + (j mod 2), in its row i div 2 and column j div 2. In
// memory columns come one behind the other, for ribbons are much longer than wide. All planes have
// the same size and a border, so that the neighbours of a whole column lie at constant distances:
// what is predicted from them is predicted side by side.
class PolyphasePlanes {
 public:
  static constexpr int count = 4;
  // The order in which they are predicted and written.
  static constexpr std::array<int, count> order = {0, 3, 1, 2};
  // Whole vectors of so many particles may be read and written in a column; what lies beyond its
  // last particle must be made good afterwards where it belongs to the border.
  static constexpr int lane_quantum = 16;

  explicit PolyphasePlanes(const RibbonGrid& grid)
      : grid_(grid),
        stride_(std::ptrdiff_t{lane_quantum} *
                (((grid.along + 1) / 2 + 2 * border + lane_quantum - 1) / lane_quantum)),
        plane_cells_(stride_ * ((grid.across + 1) / 2 + 2)) {}

  [[nodiscard]] const RibbonGrid& grid() const { return grid_; }
  // Cells of all planes with their borders.
  [[nodiscard]] std::size_t cells() const {
    return count * plane_cells_ + std::ptrdiff_t{2} * lane_quantum;
  }
  // From a cell to that of the next column.
  [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }

  // Rows and columns of a plane that hold particles.
  [[nodiscard]] int rows(int plane) const { return (grid_.along + 1 - plane / 2) / 2; }
  [[nodiscard]] int columns(int plane) const { return (grid_.across + 1 - plane % 2) / 2; }

  // The cell of row a and column b of a plane; its border is two rows and one column wide.
  [[nodiscard]] std::size_t cell(int plane, int a, int b) const {
    return lane_quantum + plane * plane_cells_ + (b + 1) * stride_ + a;
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
  // Rows of border at each end of a column.
  static constexpr int border = 2;

  RibbonGrid grid_;
  std::ptrdiff_t stride_;
  std::ptrdiff_t plane_cells_;
};

// x, y and z.
template <class T>
using Triple = std::array<T, 3>;

// One number for each cell, for x, y and z.
template <class Number>
using PlaneFields = Triple<std::vector<Number>>;

}  // namespace ribbon

// The particles of a ribbon, column by column (FORMAT.md, section 8.2).
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// Columns come one behind the other, for ribbons are much longer than wide: what is predicted from
// the column before is predicted side by side along the ribbon. A border of one row and one column
// gives every particle all its neighbours; columns begin with a cache line, which vectors that lie
// across two of them would take twice as long to come from.
class ParticleColumns {
 public:
  explicit ParticleColumns(const RibbonGrid& grid)
      : grid_(grid), stride_((static_cast<std::size_t>(grid.along) + 2 + line - 1) / line * line) {}

  [[nodiscard]] const RibbonGrid& grid() const { return grid_; }
  // From a cell to its neighbour in the next column.
  [[nodiscard]] std::size_t stride() const { return stride_; }
  // Of all columns with their borders.
  [[nodiscard]] std::size_t cells() const {
    return stride_ * (static_cast<std::size_t>(grid_.across) + 2) + line;
  }
  // Of particle (i, j); i from -1 to along, j from -1 to across: the border.
  [[nodiscard]] std::size_t cell(int i, int j) const {
    return stride_ * static_cast<std::size_t>(j + 1) + line + static_cast<std::size_t>(i);
  }

 private:
  // Values in a cache line: columns begin with one.
  static constexpr std::size_t line = 16;

  RibbonGrid grid_;
  std::size_t stride_;
};

// Begins where a cache line does.
template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};
  LineAllocator() = default;
  template <class U>
  explicit LineAllocator(const LineAllocator<U>& /*other*/) {}
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), alignment));
  }
  void deallocate(T* first, std::size_t /*count*/) { ::operator delete(first, alignment); }
  bool operator==(const LineAllocator&) const = default;
};
template <class T>
using Lines = std::vector<T, LineAllocator<T>>;

// x, y and z.
template <class T>
using Triple = std::array<T, 3>;

// A value for each cell, of x, y and z.
using CellValues = Triple<Lines<float>>;

}  // namespace ribbon

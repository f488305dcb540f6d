// A part of a ribbon that is looked at as if it were all: what is knotted between two places.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// Rows after one another, a ribbon of their own.
struct RibbonPart {
  int first_row = 0;  // even, so that quads are split into the triangles of the whole
  int last_row = 0;   // above first_row

  [[nodiscard]] RibbonGrid grid(const RibbonGrid& whole) const {
    return {last_row - first_row + 1, whole.across};
  }
  // 3 x particles of the whole; of the part.
  [[nodiscard]] Eigen::Matrix3Xf positions(const RibbonGrid& whole,
                                           const Eigen::Matrix3Xf& of_whole) const {
    return of_whole.middleCols(whole.particle(first_row, 0), grid(whole).particle_count());
  }

  bool operator==(const RibbonPart&) const = default;
};

// Between two places of it, given in either order as shares of its length, 0 to 1. Nothing where
// they lie at the same row.
std::optional<RibbonPart> part_between(const RibbonGrid& grid, double one, double other);

}  // namespace ribbon

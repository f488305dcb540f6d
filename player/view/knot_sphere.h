// Where in a frame the knot is.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

struct Sphere {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius_m = 0;
};

// Around all rows that lie on another part of the ribbon, or soon will: their middles are less than
// 1.2 widths from each other, but more than 2.5 along the ribbon. positions: 3 x particles, metres.
// Nothing where there are none.
std::optional<Sphere> knot_sphere(const RibbonGrid& grid, float width_m, float length_m,
                                  const Eigen::Matrix3Xf& positions);

// The spheres of frames at these times (seconds, ascending), as a camera follows them: each is the
// mean of those around it, weighted by a bell of about half a second. Frames without one get theirs
// from their neighbours. At least one frame must have one.
std::vector<Sphere> followed(const std::vector<double>& times_s,
                             const std::vector<std::optional<Sphere>>& spheres);

}  // namespace ribbon

// What is in the way of a ray? Directions in which a ribbon's end sees the ribbon.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace ribbon {

// Between two unit vectors, 0 to pi; the same bits from any C library.
double angle_between_units(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// A bundle of directions.
struct ViewCone {
  Eigen::Vector3d axis;   // unit length
  double half_angle_rad;  // pi: all directions
};

// Four corners of what an edge pq sweeps while it moves straight, as vectors from a point that
// moves too: p before, q before, p after, q after.
using SweptEdge = std::array<Eigen::Vector3d, 4>;

// Appends narrow cones that together hold every direction in which a ray from the origin meets the
// swept edge. Where that surface comes very near the origin they hold more, never less.
void append_view_cones(const SweptEdge& swept, std::vector<ViewCone>& cones);

// The angle in radians by which all cones are missed by every ray that is nearer than it to the
// unit vector `direction`; negative where a cone holds it, and pi if there are none.
double clearance_rad(const std::vector<ViewCone>& cones, const Eigen::Vector3d& direction);

}  // namespace ribbon

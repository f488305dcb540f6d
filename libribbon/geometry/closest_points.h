// Closest points of the two pairs of shapes that collide in cloth.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// The point of triangle abc that is closest to p, as barycentric weights of a, b and c (each in
// [0, 1], sum 1). A degenerate triangle is treated as its longest edge or its first corner.
Eigen::Vector3d closest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c);

// The closest points of segments ab and cd, as parameters (s, t) in [0, 1] from a to b and from c
// to d. Parallel or degenerate segments give one of their closest pairs.
Eigen::Vector2d closest_on_segments(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                    const Eigen::Vector3d& c, const Eigen::Vector3d& d);

}  // namespace ribbon

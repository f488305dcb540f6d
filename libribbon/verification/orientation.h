// On which side? The answers are certain, whatever the coordinates.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// The sign (-1, 0, 1) of the determinant of b - a, c - a, d - a: 1 where a, b, c turn
// counter-clockwise seen from d's side of their plane, 0 where all four lie in one plane. Exact for
// all finite coordinates, the tiniest and the largest included.
int side_of_plane(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                  const Eigen::Vector3f& d);

// The sign of the determinant of b - a, c - a: 1 where a, b, c turn counter-clockwise, 0 where they
// lie on one line. Exact likewise.
int turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c);

}  // namespace ribbon

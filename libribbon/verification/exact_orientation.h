// The signs of orientation.h without any rounding: always certain, twenty times slower.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// All coordinates must be finite.
int exact_side_of_plane(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                        const Eigen::Vector3f& c, const Eigen::Vector3f& d);
int exact_turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c);

}  // namespace ribbon

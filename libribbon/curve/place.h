// Numbers and places of the drawing as errors name them.
#pragma once

#include <Eigen/Core>
#include <string>

namespace ribbon {

// The value (> 0) to three digits.
std::string three_digits(double value);

// "(12.3, -4)"
std::string coordinates(const Eigen::Vector2d& point);

// "drawing at (12.3, -4)", in drawing units.
std::string drawing_place(const Eigen::Vector2d& point);

}  // namespace ribbon

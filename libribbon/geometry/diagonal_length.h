// Lengths that are the same bits with any C library.
#pragma once

#include <cmath>

namespace ribbon {

// Of a right angle with these sides: of exactly rounded operations alone, which std::hypot is not.
// The sides' squares must be numbers.
inline double diagonal_length(double a, double b) {
  return std::sqrt(a * a + b * b);
}

}  // namespace ribbon

// What single precision, in which positions are recorded, keeps of a number.
#pragma once

#include <algorithm>
#include <cmath>

namespace ribbon {

// How far numbers of this magnitude and less are moved at most: half of the last of 24 digits. Of
// those beyond the smallest normal one.
inline double largest_rounding(double magnitude) {
  return std::ldexp(magnitude, -24);
}

// From a number, which must be finite, to the next one away from 0.
inline double last_place(float number) {
  constexpr int smallest_normal = -126;
  return std::ldexp(1.0, std::max(std::ilogb(number), smallest_normal) - 23);
}

}  // namespace ribbon

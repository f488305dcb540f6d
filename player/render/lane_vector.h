// A vector of one lane, which compilers keep in one register for each coordinate of many lanes, as
// they do not with Eigen's.
#pragma once

#include <cmath>
#include <cstddef>

#include "player/picture/color.h"

namespace ribbon {

struct LaneVector {
  float x, y, z;
};

[[gnu::always_inline]] inline LaneVector operator+(LaneVector a, LaneVector b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[gnu::always_inline]] inline LaneVector operator-(LaneVector a, LaneVector b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline LaneVector operator*(float factor, LaneVector a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
[[gnu::always_inline]] inline LaneVector operator*(LaneVector a, LaneVector b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
[[gnu::always_inline]] inline float dot(LaneVector a, LaneVector b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[gnu::always_inline]] inline LaneVector cross(LaneVector a, LaneVector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Zero where it is too short to have a direction. The same bits as with Eigen, which sums in this
// order.
[[gnu::always_inline]] inline LaneVector unit_or_zero(LaneVector vector) {
  const float length = std::sqrt(vector.x * vector.x + (vector.y * vector.y + vector.z * vector.z));
  const bool usable = length > 1e-20F;
  const float divisor = usable ? length : 1.0F;
  return {usable ? vector.x / divisor : 0.0F, usable ? vector.y / divisor : 0.0F,
          usable ? vector.z / divisor : 0.0F};
}

// Of a colour.
[[gnu::always_inline]] inline float luminance(LaneVector light) {
  return 0.2126F * light.x + 0.7152F * light.y + 0.0722F * light.z;
}

inline LaneVector lane_vector(const Color& color) {
  return {color[0], color[1], color[2]};
}

// From and to what holds a coordinate of many lanes in each of x, y and z.
template <class Vectors>
[[gnu::always_inline]] inline LaneVector lane_of(const Vectors& vectors, std::size_t lane) {
  return {vectors.x[lane], vectors.y[lane], vectors.z[lane]};
}
template <class Vectors>
[[gnu::always_inline]] inline void set_lane(Vectors& vectors, std::size_t lane, LaneVector to) {
  vectors.x[lane] = to.x;
  vectors.y[lane] = to.y;
  vectors.z[lane] = to.z;
}

}  // namespace ribbon

#include "geometry/angles.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace ribbon {

namespace {

// An angle as whole right angles and a rest between -pi/4 and pi/4.
struct Reduced {
  int quarter = 0;  // 0 to 3: the right angles modulo 4
  double rest = 0;
};

// Cody and Waite, "Software Manual for the Elementary Functions", 1980: pi/2 in parts of 33 bits,
// so that their products with the number of right angles are exact.
Reduced reduced(double angle) {
  constexpr double most = 1e6;
  constexpr double first_part = 0x1.921fb544p+0;
  constexpr double second_part = 0x1.0b4611a6p-34;
  constexpr double third_part = 0x1.3198a2ep-69;
  if (!(std::abs(angle) <= most)) return {0, std::numeric_limits<double>::quiet_NaN()};
  const double right_angles = std::round(angle * (2 / std::numbers::pi));
  const double rest =
      angle - right_angles * first_part - right_angles * second_part - right_angles * third_part;
  return {static_cast<int>(right_angles) & 3, rest};
}

// Taylor's series, for angles up to pi/4; what follows is below any rounding.
constexpr int last_power = 20;

double series_of_cosine(double angle) {
  double sum = 1;
  for (int power = last_power; power > 0; power -= 2)
    sum = 1 - angle * angle / (power * (power - 1)) * sum;
  return sum;
}

double series_of_sine(double angle) {
  double sum = 1;
  for (int power = last_power; power > 0; power -= 2)
    sum = 1 - angle * angle / (power * (power + 1)) * sum;
  return angle * sum;
}

// The tangent of half of the angle that has this tangent.
double halved(double tangent) {
  return tangent / (1 + std::sqrt(1 + tangent * tangent));
}

// For tangents from 0 to 1: of a quarter of the angle the series soon ends.
double arc_tangent(double tangent) {
  constexpr int last_term = 12;
  const double quarter = halved(halved(tangent));
  double sum = 0;
  for (int term = last_term; term >= 0; --term)
    sum = 1.0 / (2 * term + 1) - quarter * quarter * sum;
  return 4 * quarter * sum;
}

}  // namespace

double cosine(double angle) {
  const auto [quarter, rest] = reduced(angle);
  const double value = quarter % 2 == 0 ? series_of_cosine(rest) : series_of_sine(rest);
  return quarter == 1 || quarter == 2 ? -value : value;
}

double sine(double angle) {
  const auto [quarter, rest] = reduced(angle);
  const double value = quarter % 2 == 0 ? series_of_sine(rest) : series_of_cosine(rest);
  return quarter >= 2 ? -value : value;
}

double polar_angle(double x, double y) {
  const double width = std::abs(x);
  const double height = std::abs(y);
  if (width == 0 && height == 0) return 0;
  const double first_quadrant = height <= width
                                    ? arc_tangent(height / width)
                                    : std::numbers::pi / 2 - arc_tangent(width / height);
  const double upper_half = x < 0 ? std::numbers::pi - first_quadrant : first_quadrant;
  return y < 0 ? -upper_half : upper_half;
}

}  // namespace ribbon

#include "verification/exact_orientation.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>
#include <cmath>
#include <limits>

namespace ribbon {

namespace {

namespace mp = boost::multiprecision;

// A finite single-precision number is a whole multiple of 2^-172 (24 binary digits below the
// leading one of the smallest denormal, 2^-149) and smaller than 2^128. So coordinates have at most
// 300 binary digits, differences 301, sums of six products of three of them 906.
using Integer =
    mp::number<mp::cpp_int_backend<1024, 1024, mp::signed_magnitude, mp::unchecked, void>>;

constexpr int mantissa_digits = std::numeric_limits<float>::digits;

// The binary exponent of the last digit that `number` may have; a large one for 0.
int last_digit(float number) {
  if (number == 0) return std::numeric_limits<int>::max();
  int exponent = 0;
  (void)std::frexp(number, &exponent);
  return exponent - mantissa_digits;
}

// number / 2^unit; unit <= last_digit(number).
Integer in_units(float number, int unit) {
  if (number == 0) return 0;
  int exponent = 0;
  const float mantissa = std::frexp(number, &exponent);
  const auto digits = static_cast<int>(std::ldexp(mantissa, mantissa_digits));
  return Integer(digits) << (exponent - mantissa_digits - unit);
}

// Points (columns) in whole multiples of the largest power of two that allows it. A common factor
// does not change a determinant's sign.
template <class Points>
Eigen::Matrix<Integer, Points::RowsAtCompileTime, Points::ColsAtCompileTime> in_common_units(
    const Points& points) {
  assert(points.allFinite());
  int unit = std::numeric_limits<int>::max();
  for (const float coordinate : points.reshaped()) unit = std::min(unit, last_digit(coordinate));
  Eigen::Matrix<Integer, Points::RowsAtCompileTime, Points::ColsAtCompileTime> result;
  for (int column = 0; column < points.cols(); ++column)
    for (int row = 0; row < points.rows(); ++row)
      result(row, column) = in_units(points(row, column), unit);
  return result;
}

int sign(const Integer& number) {
  return number.sign();
}

Integer minor_of(const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  return Integer(a * d) - Integer(b * c);
}

}  // namespace

int exact_side_of_plane(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                        const Eigen::Vector3f& c, const Eigen::Vector3f& d) {
  Eigen::Matrix<float, 3, 4> points;
  points << a, b, c, d;
  auto x = in_common_units(points);
  for (int k = 1; k < 4; ++k)
    for (int row = 0; row < 3; ++row) x(row, k) -= x(row, 0);
  return sign(x(0, 1) * minor_of(x(1, 2), x(1, 3), x(2, 2), x(2, 3)) +
              x(1, 1) * minor_of(x(2, 2), x(2, 3), x(0, 2), x(0, 3)) +
              x(2, 1) * minor_of(x(0, 2), x(0, 3), x(1, 2), x(1, 3)));
}

int exact_turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
  Eigen::Matrix<float, 2, 3> points;
  points << a, b, c;
  auto x = in_common_units(points);
  for (int k = 1; k < 3; ++k)
    for (int row = 0; row < 2; ++row) x(row, k) -= x(row, 0);
  return sign(minor_of(x(0, 1), x(0, 2), x(1, 1), x(1, 2)));
}

}  // namespace ribbon

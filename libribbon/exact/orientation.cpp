#include "exact/orientation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>
#include <cfloat>
#include <climits>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

namespace ribbon {
namespace {

using Eigen::Vector3d;

// With u = 2^-53, each product of a determinant of differences passes at most 9 roundings (three
// differences, two products, one sum within the minor, three at most outside), so that the computed
// determinant is off by less than 10 u times the sum of the products' absolute values, and that
// sum, computed likewise, by less than 10 u of itself. 16 u covers both, unless products underflow.
constexpr double relative_error = 0x1p-49;
// Of sums above it, what underflow can have taken away is less than a rounding.
constexpr double smallest_sum = DBL_MIN / DBL_EPSILON;

struct Determinant {
  double value = 0;
  double size = 0;  // the same sum, of absolute values: what rounding errors scale with
};

Determinant determinant(const Vector3d& p, const Vector3d& q, const Vector3d& r) {
  const double yz = q.y() * r.z();
  const double zy = q.z() * r.y();
  const double zx = q.z() * r.x();
  const double xz = q.x() * r.z();
  const double xy = q.x() * r.y();
  const double yx = q.y() * r.x();
  return {p.x() * (yz - zy) + p.y() * (zx - xz) + p.z() * (xy - yx),
          std::abs(p.x()) * (std::abs(yz) + std::abs(zy)) +
              std::abs(p.y()) * (std::abs(zx) + std::abs(xz)) +
              std::abs(p.z()) * (std::abs(xy) + std::abs(yx))};
}

int sign_of(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

// Four points in such an order that the last one is no direction, if one is not. Their orientation
// is `sign` times the determinant of the first three less the last one, directions as they are.
struct Reordered {
  explicit Reordered(const std::array<const ProjectivePoint*, 4>& order) : points(order) {
    int pivot = 3;
    while (pivot >= 0 && points[pivot]->is_direction) --pivot;
    if (pivot < 0) return;
    std::swap(points[pivot], points[3]);
    sign = pivot == 3 ? -1 : 1;
  }

  std::array<const ProjectivePoint*, 4> points;
  int sign = 0;  // 0: all are directions
};

struct Estimate {
  double value = 0;
  double error = 0;  // at most
};

Estimate estimate(const Reordered& four) {
  if (four.sign == 0) return {};
  std::array<Vector3d, 3> rows;
  for (int i = 0; i < 3; ++i) {
    rows[i] = four.points[i]->at;
    if (!four.points[i]->is_direction) rows[i] -= four.points[3]->at;
  }
  const auto [value, size] = determinant(rows[0], rows[1], rows[2]);
  return {four.sign * value, size > smallest_sum ? relative_error * size : DBL_MAX};
}

Estimate product_of_sizes(const Estimate& a, const Estimate& b) {
  const double size_a = std::abs(a.value);
  const double size_b = std::abs(b.value);
  const double error = (size_a + a.error) * b.error + a.error * size_b + DBL_MIN;
  return {size_a * size_b, error + DBL_EPSILON * (error + size_a * size_b)};
}

// Without expression templates, so that `auto` and lambdas may return what an operator returns.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

// A number as digits * 2^exponent, the digits odd (or 0).
struct Binary {
  explicit Binary(double number) {
    assert(std::isfinite(number));
    if (number == 0) return;
    digits = static_cast<std::int64_t>(std::ldexp(std::frexp(number, &exponent), DBL_MANT_DIG));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(digits));
    digits >>= zeros;
    exponent += zeros - DBL_MANT_DIG;
  }

  std::int64_t digits = 0;
  int exponent = INT_MAX;
};

// Coordinates in units of the largest power of two that all of them are multiples of.
class CommonUnit {
 public:
  explicit CommonUnit(std::span<const ProjectivePoint* const> points) {
    for (const ProjectivePoint* point : points)
      for (const double number : point->at)
        exponent_ = std::min(exponent_, Binary(number).exponent);
  }

  [[nodiscard]] std::array<Integer, 3> operator()(const Vector3d& at) const {
    return {integer(at.x()), integer(at.y()), integer(at.z())};
  }

 private:
  [[nodiscard]] Integer integer(double number) const {
    const Binary binary(number);
    return binary.digits == 0 ? Integer(0)
                              : Integer(binary.digits) << (binary.exponent - exponent_);
  }

  int exponent_ = INT_MAX;
};

// The determinant that `estimate` estimates, in cubic units.
Integer exact_determinant(const Reordered& four, const CommonUnit& in_units) {
  if (four.sign == 0) return 0;
  const auto origin = in_units(four.points[3]->at);
  std::array<std::array<Integer, 3>, 3> m;
  for (int i = 0; i < 3; ++i) {
    m[i] = in_units(four.points[i]->at);
    if (four.points[i]->is_direction) continue;
    for (int axis = 0; axis < 3; ++axis) m[i][axis] -= origin[axis];
  }
  return four.sign * (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
                      m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
                      m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

int exact_orientation(const Reordered& four) {
  return exact_determinant(four, CommonUnit(four.points)).sign();
}

}  // namespace

int orientation(const ProjectivePoint& a, const ProjectivePoint& b, const ProjectivePoint& c,
                const ProjectivePoint& d) {
  const Reordered four({&a, &b, &c, &d});
  const Estimate rounded = estimate(four);
  if (std::abs(rounded.value) > rounded.error) return sign_of(rounded.value);
  return exact_orientation(four);
}

// Nothing overflows or underflows: differences of single-precision numbers are 0 or from 2^-149 to
// 2^129 in size, so products of three are 0 or from 2^-447 to 2^387.
int side_of_plane(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                  const Eigen::Vector3f& d) {
  const Vector3d origin = a.cast<double>();
  const auto [value, size] =
      determinant(b.cast<double>() - origin, c.cast<double>() - origin, d.cast<double>() - origin);
  if (std::abs(value) > relative_error * size) return sign_of(value);
  if (size == 0) return 0;
  return orientation(ProjectivePoint::point(origin), ProjectivePoint::point(b.cast<double>()),
                     ProjectivePoint::point(c.cast<double>()),
                     ProjectivePoint::point(d.cast<double>()));
}

int turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
  const Eigen::Vector2d p = b.cast<double>() - a.cast<double>();
  const Eigen::Vector2d q = c.cast<double>() - a.cast<double>();
  const double xy = p.x() * q.y();
  const double yx = p.y() * q.x();
  const double size = std::abs(xy) + std::abs(yx);
  if (std::abs(xy - yx) > relative_error * size) return sign_of(xy - yx);
  if (size == 0) return 0;
  const auto in_plane = [](const Eigen::Vector2f& point) {
    return ProjectivePoint::point({point.x(), point.y(), 0});
  };
  return orientation(in_plane(a), in_plane(b), in_plane(c),
                     ProjectivePoint::direction(Vector3d::UnitZ()));
}

int order_along(const ProjectivePoint& p, const ProjectivePoint& q, const ProjectivePoint& r,
                const ProjectivePoint& s, const ProjectivePoint& u, const ProjectivePoint& w,
                const ProjectivePoint& view) {
  // Line rs is met at the fraction |rsp| / (|rsp| + |rsq|) of the way, rsp and rsq being areas as
  // seen.
  const Reordered rsp({&r, &s, &p, &view});
  const Reordered rsq({&r, &s, &q, &view});
  const Reordered uwp({&u, &w, &p, &view});
  const Reordered uwq({&u, &w, &q, &view});
  const Estimate rs_later = product_of_sizes(estimate(rsp), estimate(uwq));
  const Estimate uw_later = product_of_sizes(estimate(uwp), estimate(rsq));
  const double difference = rs_later.value - uw_later.value;
  if (std::abs(difference) > rs_later.error + uw_later.error) return sign_of(difference);
  const CommonUnit in_units(std::array{&p, &q, &r, &s, &u, &w, &view});
  const auto area = [&](const Reordered& four) { return abs(exact_determinant(four, in_units)); };
  return Integer(area(rsp) * area(uwq) - area(uwp) * area(rsq)).sign();
}

}  // namespace ribbon

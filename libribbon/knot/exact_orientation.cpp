#include "knot/exact_orientation.h"

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cfloat>
#include <cmath>
#include <utility>

namespace ribbon {
namespace {

// Without expression templates, so that `auto` and lambdas may return what an operator returns.
using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                               boost::multiprecision::et_off>;
using Places = std::array<const Place*, 4>;

template <typename Number>
using Row = std::array<Number, 3>;

// What is left of det [at, is_point] when one point is subtracted from the others: three rows, and
// the sign that moving that point to the last row gave.
template <typename Number>
struct Reduced {
  std::array<Row<Number>, 3> rows;
  int sign = 0;
};

template <typename Number>
Reduced<Number> reduce(Places places) {
  Reduced<Number> result;
  for (std::size_t pivot = 0; pivot < 4 && result.sign == 0; ++pivot) {
    if (places[pivot]->is_direction) continue;
    std::swap(places[pivot], places[3]);
    // det [a b c d] = -det(b - a, c - a, d - a), and each swap turns it.
    result.sign = pivot == 3 ? -1 : 1;
  }
  if (result.sign == 0) return result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<Eigen::Index>(axis);
      Number& entry = result.rows[i][axis];
      entry = Number(places[i]->at[k]);
      if (!places[i]->is_direction) entry -= Number(places[3]->at[k]);
    }
  }
  return result;
}

template <typename Number>
Number determinant(const std::array<Row<Number>, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
         m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// The determinant of the absolute values, with all signs positive: what rounding errors scale with.
double permanent(const std::array<Row<double>, 3>& m) {
  const auto term = [&m](std::size_t i, std::size_t j, std::size_t k) {
    return std::abs(m[0][i]) *
           (std::abs(m[1][j]) * std::abs(m[2][k]) + std::abs(m[1][k]) * std::abs(m[2][j]));
  };
  return term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1);
}

Rational exact_determinant(const Places& places) {
  const Reduced<Rational> exact = reduce<Rational>(places);
  if (exact.sign == 0) return Rational(0);
  return exact.sign * determinant(exact.rows);
}

}  // namespace

int orientation(const Place& a, const Place& b, const Place& c, const Place& d) {
  const Places places{&a, &b, &c, &d};
  const Reduced<double> rounded = reduce<double>(places);
  if (rounded.sign == 0) return 0;
  const double value = determinant(rounded.rows);
  const double scale = permanent(rounded.rows);
  // Rounding: at most (7 + 56 u) u times the permanent, u = DBL_EPSILON / 2 (Shewchuk, "Adaptive
  // precision floating-point arithmetic", 1997, section 4.3), unless products underflow.
  if (scale > DBL_MIN / DBL_EPSILON && std::abs(value) > 4 * DBL_EPSILON * scale)
    return value > 0 ? rounded.sign : -rounded.sign;
  return exact_determinant(places).sign();
}

int order_along(const Place& p, const Place& q, const Place& r, const Place& s, const Place& u,
                const Place& w, const Place& view) {
  // Line rs is met at the share |a| / (|a| + |b|) of the way, a and b being the areas rsp and rsq.
  const auto area = [&view](const Place& from, const Place& to, const Place& corner) {
    const Rational twice = exact_determinant({&from, &to, &corner, &view});
    return twice.sign() < 0 ? Rational(-twice) : twice;
  };
  return Rational(area(r, s, p) * area(u, w, q) - area(u, w, p) * area(r, s, q)).sign();
}

}  // namespace ribbon

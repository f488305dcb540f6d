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
  if (exact.sign == 0) return 0;
  return exact.sign * determinant(exact.rows);
}

struct Estimate {
  double value = 0;
  double error = 0;  // at most
};

// The determinant in double precision. Errors grow to at most (7 + 56 u) u times the permanent,
// u = DBL_EPSILON / 2 (Shewchuk, "Adaptive precision floating-point arithmetic", 1997,
// section 4.3), unless products underflow.
Estimate estimate(const Places& places) {
  const Reduced<double> rounded = reduce<double>(places);
  if (rounded.sign == 0) return {};
  const double scale = permanent(rounded.rows);
  const double error = scale > DBL_MIN / DBL_EPSILON ? 4 * DBL_EPSILON * scale : DBL_MAX;
  return {rounded.sign * determinant(rounded.rows), error};
}

Estimate product_of_sizes(const Estimate& a, const Estimate& b) {
  const double size_a = std::abs(a.value);
  const double size_b = std::abs(b.value);
  const double error = (size_a + a.error) * b.error + a.error * size_b + DBL_MIN;
  return {size_a * size_b, error + DBL_EPSILON * (error + size_a * size_b)};
}

int sign_of(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

Rational size(const Rational& number) {
  return number.sign() < 0 ? Rational(-number) : number;
}

}  // namespace

int orientation(const Place& a, const Place& b, const Place& c, const Place& d) {
  const Places places{&a, &b, &c, &d};
  const Estimate rounded = estimate(places);
  if (std::abs(rounded.value) > rounded.error) return sign_of(rounded.value);
  return exact_determinant(places).sign();
}

int order_along(const Place& p, const Place& q, const Place& r, const Place& s, const Place& u,
                const Place& w, const Place& view) {
  // Line rs is met at the share |rsp| / (|rsp| + |rsq|) of the way, rsp and rsq being areas as
  // seen.
  const Places rsp{&r, &s, &p, &view};
  const Places rsq{&r, &s, &q, &view};
  const Places uwp{&u, &w, &p, &view};
  const Places uwq{&u, &w, &q, &view};
  const Estimate rs_later = product_of_sizes(estimate(rsp), estimate(uwq));
  const Estimate uw_later = product_of_sizes(estimate(uwp), estimate(rsq));
  const double difference = rs_later.value - uw_later.value;
  if (std::abs(difference) > rs_later.error + uw_later.error) return sign_of(difference);
  return Rational(size(exact_determinant(rsp)) * size(exact_determinant(uwq)) -
                  size(exact_determinant(uwp)) * size(exact_determinant(rsq)))
      .sign();
}

}  // namespace ribbon

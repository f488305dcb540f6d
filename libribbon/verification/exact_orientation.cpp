#include "verification/exact_orientation.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace ribbon {

namespace {

// Single-precision numbers have 24 binary digits, so that doubles hold the product of two exactly,
// and two doubles the product of three. A determinant of coordinates is a sum of at most 48 such
// doubles, and their exact sum has the sign in question. Sizes are 0 or from 2^-447 to 2^384, far
// from where doubles end.

// A sum of doubles as parts whose digits do not overlap, the smallest first, none of them 0: the
// last one has the sum's sign (Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast
// Robust Geometric Predicates, 1997, theorem 10).
class ExactSum {
 public:
  void add(double number) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const double sum = number + parts_[k];
      const double error = rounding_error(number, parts_[k], sum);
      if (error != 0) parts_[kept++] = error;
      number = sum;
    }
    if (number != 0) parts_[kept++] = number;
    count_ = kept;
    assert(count_ < parts_.size());
  }

  [[nodiscard]] int sign() const {
    if (count_ == 0) return 0;
    return parts_[count_ - 1] > 0 ? 1 : -1;
  }

 private:
  // What a + b is more than its rounded sum, exactly (theorem 7).
  static double rounding_error(double a, double b, double sum) {
    const double b_part = sum - a;
    return (a - (sum - b_part)) + (b - b_part);
  }

  // Each number adds at most one part.
  std::array<double, 49> parts_{};
  std::size_t count_ = 0;
};

void add_product(ExactSum& sum, double x, double y, double z) {
  const double xy = x * y;
  const double product = xy * z;
  sum.add(std::fma(xy, z, -product));
  sum.add(product);
}

// Adds sign * det(p, q, r).
void add_determinant(ExactSum& sum, double sign, const Eigen::Vector3f& p, const Eigen::Vector3f& q,
                     const Eigen::Vector3f& r) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    add_product(sum, sign * p[i], q[j], r[k]);
    add_product(sum, -sign * p[i], q[k], r[j]);
  }
}

void add_determinant(ExactSum& sum, double sign, const Eigen::Vector2f& p,
                     const Eigen::Vector2f& q) {
  sum.add(sign * p.x() * q.y());
  sum.add(-sign * p.y() * q.x());
}

}  // namespace

// det(b - a, c - a, d - a) multiplied out.
int exact_side_of_plane(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                        const Eigen::Vector3f& c, const Eigen::Vector3f& d) {
  assert(a.allFinite() && b.allFinite() && c.allFinite() && d.allFinite());
  ExactSum sum;
  add_determinant(sum, 1, b, c, d);
  add_determinant(sum, -1, a, c, d);
  add_determinant(sum, 1, a, b, d);
  add_determinant(sum, -1, a, b, c);
  return sum.sign();
}

int exact_turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
  assert(a.allFinite() && b.allFinite() && c.allFinite());
  ExactSum sum;
  add_determinant(sum, 1, b, c);
  add_determinant(sum, -1, a, c);
  add_determinant(sum, 1, a, b);
  return sum.sign();
}

}  // namespace ribbon

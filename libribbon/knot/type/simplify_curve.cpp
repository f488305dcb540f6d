#include "knot/type/simplify_curve.h"

#include <cassert>
#include <iterator>
#include <limits>
#include <utility>

#include "geometry/box.h"

namespace ribbon {
namespace {

struct Corner {
  ProjectivePoint a, b, c;
};

Box box_around(const Corner& triangle) {
  const auto all = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  const auto& [a, b, c] = triangle;
  if (a.is_direction || c.is_direction) return {-all, all};
  Box result = Box::around(a.at);
  result.include(b.at);
  result.include(c.at);
  return result;
}

// Quick to tell of most edges that they miss the triangle in the box.
bool misses(const Box& box, const ProjectivePoint& p, const ProjectivePoint& q) {
  if (p.is_direction || q.is_direction) return false;
  return (p.at.array() < box.low.array() && q.at.array() < box.low.array()).any() ||
         (p.at.array() > box.high.array() && q.at.array() > box.high.array()).any();
}

// Does edge pq meet the triangle? In doubt, yes.
bool meets(const Corner& triangle, const ProjectivePoint& p, const ProjectivePoint& q) {
  const auto& [a, b, c] = triangle;
  if (orientation(a, b, c, p) * orientation(a, b, c, q) > 0) return false;
  const int ab = orientation(p, q, a, b);
  const int bc = orientation(p, q, b, c);
  const int ca = orientation(p, q, c, a);
  const bool all_left = ab >= 0 && bc >= 0 && ca >= 0;
  const bool all_right = ab <= 0 && bc <= 0 && ca <= 0;
  return all_left || all_right;
}

using Vertex = LongCurve::const_iterator;

// Is the triangle met by the polygon from `first` up to and without `last`?
bool met_by(const Corner& triangle, const Box& box, Vertex first, Vertex last) {
  if (first == last) return false;
  for (auto next = std::next(first); next != last; first = next++)
    if (!misses(box, *first, *next) && meets(triangle, *first, *next)) return true;
  return false;
}

// Can the last of `kept` be joined to the second of the rest, leaving out the first of the rest?
bool can_leave_out(const LongCurve& kept, Vertex rest, Vertex end) {
  const auto next = std::next(rest);
  const Corner triangle{kept.back(), *rest, *next};
  const auto& [a, b, c] = triangle;
  if (a.is_direction && c.is_direction) return false;  // something must stay
  // The edges before a and after c touch it there, and nowhere else unless they lie in its plane.
  if (kept.size() >= 2 && orientation(a, b, c, *std::prev(kept.end(), 2)) == 0) return false;
  if (std::next(next) != end && orientation(a, b, c, *std::next(next)) == 0) return false;
  const Box box = box_around(triangle);
  return !met_by(triangle, box, kept.begin(), std::prev(kept.end())) &&
         !met_by(triangle, box, std::next(next), end);
}

LongCurve one_sweep(const LongCurve& curve) {
  LongCurve kept{curve.front()};
  for (auto rest = std::next(curve.begin()); rest != std::prev(curve.end()); ++rest)
    if (!can_leave_out(kept, rest, curve.end())) kept.push_back(*rest);
  kept.push_back(curve.back());
  return kept;
}

}  // namespace

LongCurve simplified(LongCurve curve) {
  assert(curve.size() >= 3 && curve.front().is_direction && curve.back().is_direction);
  for (;;) {
    LongCurve shorter = one_sweep(curve);
    if (shorter.size() == curve.size()) return curve;
    curve = std::move(shorter);
  }
}

}  // namespace ribbon

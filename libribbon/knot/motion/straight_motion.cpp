#include "knot/motion/straight_motion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

#include "geometry/box.h"
#include "geometry/closest_points.h"
#include "geometry/vectors.h"

namespace ribbon {
namespace {

struct MovingEdge {
  std::array<Eigen::Vector3d, 2> before;
  std::array<Eigen::Vector3d, 2> now;
  Box swept;
  Eigen::Index place;  // along its curve

  // The edge when a share of the time has gone by.
  [[nodiscard]] std::array<Eigen::Vector3d, 2> at(double share) const {
    return {before[0] + share * (now[0] - before[0]), before[1] + share * (now[1] - before[1])};
  }
};

std::vector<MovingEdge> edges_of(const MovingCurve& curve) {
  assert(curve.before.cols() == curve.now.cols());
  std::vector<MovingEdge> result;
  for (Eigen::Index k = 0; k + 1 < curve.before.cols(); ++k) {
    MovingEdge edge{{curve.before.col(k), curve.before.col(k + 1)},
                    {curve.now.col(k), curve.now.col(k + 1)},
                    Box::around(curve.before.col(k)),
                    k};
    for (const Eigen::Vector3d& point : {edge.before[1], edge.now[0], edge.now[1]})
      edge.swept.include(point);
    result.push_back(edge);
  }
  return result;
}

// Far more than the arithmetic below loses.
double rounding_of(const MovingCurve& curve) {
  return 1e-12 * std::max(curve.before.cwiseAbs().maxCoeff(), curve.now.cwiseAbs().maxCoeff());
}

// Does all of `one` lie farther along the direction than all of `other`?
bool lies_beyond(const std::array<Eigen::Vector3d, 2>& one,
                 const std::array<Eigen::Vector3d, 2>& other, const Eigen::Vector3d& direction,
                 double rounding) {
  for (const Eigen::Vector3d& p : one)
    for (const Eigen::Vector3d& q : other)
      if (!(dot(direction, p - q) > rounding * length_of(direction))) return false;
  return true;
}

// The two keep apart where one lies beyond the other, along the same direction, at the beginning
// and at the end: what is between two points that move straight changes in proportion to time.
// Where the direction that parts them midway does not part them throughout, time is halved.
bool edges_stay_clear(const MovingEdge& one, const MovingEdge& other, double rounding,
                      double begin = 0, double end = 1) {
  constexpr double shortest_time = 1.0 / 4096;
  const double midway = (begin + end) / 2;
  const auto [a, b] = one.at(midway);
  const auto [c, d] = other.at(midway);
  const Eigen::Vector2d closest = closest_on_segments(a, b, c, d);
  const Eigen::Vector3d direction = a + closest[0] * (b - a) - c - closest[1] * (d - c);
  if (lies_beyond(one.at(begin), other.at(begin), direction, rounding) &&
      lies_beyond(one.at(end), other.at(end), direction, rounding))
    return true;
  return end - begin > shortest_time && edges_stay_clear(one, other, rounding, begin, midway) &&
         edges_stay_clear(one, other, rounding, midway, end);
}

void sort_from_left_to_right(std::vector<MovingEdge>& edges) {
  std::sort(edges.begin(), edges.end(), [](const MovingEdge& a, const MovingEdge& b) {
    return a.swept.low.x() < b.swept.low.x();
  });
}

// Of all pairs that `matter`. Both are sorted.
template <class Matter>
bool all_stay_clear(const std::vector<MovingEdge>& ones, const std::vector<MovingEdge>& others,
                    double rounding, const Matter& matter) {
  std::size_t first = 0;
  double widest = 0;
  for (const MovingEdge& other : others)
    widest = std::max(widest, other.swept.high.x() - other.swept.low.x());
  for (const MovingEdge& one : ones) {
    while (first < others.size() &&
           others[first].swept.low.x() < one.swept.low.x() - widest - rounding)
      ++first;
    for (std::size_t k = first; k < others.size() && others[k].swept.low.x() <= one.swept.high.x();
         ++k)
      if (matter(one, others[k]) && one.swept.meets(others[k].swept) &&
          !edges_stay_clear(one, others[k], rounding))
        return false;
  }
  return true;
}

}  // namespace

bool stays_clear_of_itself(const MovingCurve& curve) {
  std::vector<MovingEdge> edges = edges_of(curve);
  sort_from_left_to_right(edges);
  return all_stay_clear(
      edges, edges, rounding_of(curve),
      [](const MovingEdge& one, const MovingEdge& other) { return one.place + 1 < other.place; });
}

bool stay_clear(const MovingCurve& one, const MovingCurve& other) {
  std::vector<MovingEdge> edges = edges_of(one);
  std::vector<MovingEdge> others = edges_of(other);
  sort_from_left_to_right(edges);
  sort_from_left_to_right(others);
  return all_stay_clear(
      edges, others, std::max(rounding_of(one), rounding_of(other)),
      [](const MovingEdge& /*one*/, const MovingEdge& /*other*/) { return true; });
}

}  // namespace ribbon

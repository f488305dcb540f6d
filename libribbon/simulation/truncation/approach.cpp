#include "simulation/truncation/approach.h"

#include <algorithm>
#include <cassert>

#include "geometry/closest_points.h"
#include "geometry/vectors.h"
#include "simulation/detection/closest_weights.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Corners = Eigen::Matrix<double, 3, 4>;

// Of a distance: room that no rounding feigns.
constexpr double certain = 0.5;
// Of the distance to which features come: by so much, or less, they are still farther apart.
constexpr double close = 0.01;
// Each squares what is left, or halves it where the two would only graze each other.
constexpr int most_newton_steps = 30;

struct Instant {
  Vector3d apart;   // as Approach has it
  double when = 0;  // after this fraction of the displacement
};

// The first feature moves, and by the way of the points that are closest at the start.
struct RelativeMotion {
  FeaturePair::Kind kind;
  const Corners& start;
  Vector3d way;

  [[nodiscard]] int of_first() const { return first_count(kind); }
  [[nodiscard]] Corners at(double when) const {
    Corners then = start;
    then.leftCols(of_first()).colwise() += when * way;
    return then;
  }
  [[nodiscard]] Instant instant(double when) const {
    const Corners then = at(when);
    return {weighted_sum(then, closest_weights(kind, then)), when};
  }
};

// Of a vertex on its way, as seen from the edge pq.
Instant vertex_to_edge(const Vector3d& vertex, const Vector3d& way, const Vector3d& p,
                       const Vector3d& q) {
  const Vector2d at = closest_on_segments(vertex, vertex + way, p, q);
  return {vertex + at[0] * way - (p + at[1] * (q - p)), at[0]};
}

void take_if_shorter(const Instant& other, Instant& shortest) {
  if (squared_length_of(other.apart) < squared_length_of(shortest.apart)) shortest = other;
}

// Two convex sets that do not meet are closest on the boundary of one of them: at the start, at the
// end, or where the way of a corner lies nearest. Seen from the first feature, the second goes
// backwards.
Instant nearest_on_boundaries(const RelativeMotion& motion, const Vector3d& apart_at_start) {
  Instant nearest{apart_at_start, 0};
  take_if_shorter(motion.instant(1), nearest);
  const auto pass = [&](int vertex, int p, int q) {
    const bool is_of_first = vertex < motion.of_first();
    const Corners& start = motion.start;
    Instant passed = vertex_to_edge(start.col(vertex), is_of_first ? motion.way : -motion.way,
                                    start.col(p), start.col(q));
    if (!is_of_first) passed.apart = -passed.apart;
    take_if_shorter(passed, nearest);
  };
  if (motion.kind == FeaturePair::Kind::edge_edge) {
    pass(0, 2, 3);
    pass(1, 2, 3);
    pass(2, 0, 1);
    pass(3, 0, 1);
  } else {
    pass(0, 1, 2);
    pass(0, 2, 3);
    pass(0, 3, 1);
  }
  return nearest;
}

// Is there certainly room between all that the first feature passes over and the second?
bool certainly_separates(const Vector3d& apart, const RelativeMotion& motion) {
  const Vector4d height = heights(motion.start, apart);
  const int of_first = motion.of_first();
  const double room = height.head(of_first).minCoeff() + std::min(0.0, dot(motion.way, apart)) -
                      height.tail(4 - of_first).maxCoeff();
  return room >= certain * squared_length_of(apart);
}

// Conservative advancement: the distance of convex bodies that keep their shapes is a convex
// function of the time, so that Newton's steps from the start come ever closer to the instant, and
// never pass it.
Instant first_down_to(double near_m, const RelativeMotion& motion, const Vector3d& apart_at_start) {
  Instant reached{apart_at_start, 0};
  for (int step = 0; step < most_newton_steps && reached.when < 1; ++step) {
    const double distance_m = length_of(reached.apart);
    const double speed_m = -dot(reached.apart, motion.way) / distance_m;
    if (distance_m <= (1 + close) * near_m || speed_m <= 0) break;
    reached = motion.instant(std::min(1.0, reached.when + (distance_m - near_m) / speed_m));
  }
  return reached;
}

}  // namespace

Approach approach_down_to(double near_m, FeaturePair::Kind kind, const Corners& start,
                          const Vector4d& weights, const Corners& displacement) {
  assert(near_m > 0);
  const RelativeMotion motion{kind, start, weighted_sum(displacement, weights)};
  const Vector3d apart = weighted_sum(start, weights);
  Instant met = nearest_on_boundaries(motion, apart);
  if (squared_length_of(met.apart) <= near_m * near_m || !certainly_separates(met.apart, motion))
    met = first_down_to(near_m, motion, apart);
  return {met.apart, motion.at(met.when)};
}

}  // namespace ribbon

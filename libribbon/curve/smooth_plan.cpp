#include "curve/smooth_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/catmull_rom.h"
#include "curve/turns.h"
#include "geometry/lengths_along.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;

constexpr double finest_turn = 0.003;  // radians per chord: lengths are right to 4e-7
constexpr double coarse_turn = 0.05;   // enough to find crossings
constexpr double most_chords = 5e5;

// Between controls i and i + 1; beyond its ends the curve goes straight on.
Cubic cubic_between(const Drawing& points, std::size_t i) {
  const Vector2d& p1 = points[i];
  const Vector2d& p2 = points[i + 1];
  const Vector2d before = i == 0 ? Vector2d(2 * p1 - p2) : points[i - 1];
  const Vector2d after = i + 2 == points.size() ? Vector2d(2 * p2 - p1) : points[i + 2];
  return catmull_rom(before, p1, p2, after);
}

// No less than what the cubic turns by: the turns of its Bezier polygon.
double turn_of(const Cubic& cubic) {
  const Vector2d b1 = cubic.begin + cubic.begin_derivative / 3;
  const Vector2d b2 = cubic.end - cubic.end_derivative / 3;
  return angle_between(cubic.begin_derivative, b2 - b1) +
         angle_between(b2 - b1, cubic.end_derivative);
}

Plan smooth_plan(const Controls& controls, double chord_turn, double chord_length) {
  Plan plan{{controls.points.front()}, {}};
  auto passage = controls.passages.begin();
  for (std::size_t i = 0; i < controls.points.size(); ++i) {
    for (; passage != controls.passages.end() && *passage == i; ++passage)
      plan.passages.push_back(plan.points.size() - 1);
    if (i + 1 == controls.points.size()) break;
    const auto cubic = cubic_between(controls.points, i);
    const double wanted =
        std::max(turn_of(cubic) / chord_turn, length_of(cubic.end - cubic.begin) / chord_length);
    const auto chords = static_cast<std::size_t>(std::ceil(std::max(wanted, 1.0)));
    for (std::size_t k = 1; k <= chords; ++k)
      plan.points.push_back(cubic.at(static_cast<double>(k) / static_cast<double>(chords)));
  }
  return plan;
}

}  // namespace

Controls controls_of(const Drawing& drawing, const std::vector<Passage>& passages) {
  const double near = 1e-6 * extent_of(drawing);
  Controls controls;
  const auto is_new = [&](const Vector2d& point) {
    return controls.points.empty() || length_of(point - controls.points.back()) > near;
  };
  auto passage = passages.begin();
  for (std::size_t i = 0; i < drawing.size(); ++i) {
    if (is_new(drawing[i])) controls.points.push_back(drawing[i]);
    for (; passage != passages.end() && passage->parameter < static_cast<double>(i + 1);
         ++passage) {
      if (is_new(passage->point)) controls.points.push_back(passage->point);
      controls.passages.push_back(controls.points.size() - 1);
    }
  }
  return controls;
}

Plan coarse_plan(const Controls& controls) {
  return smooth_plan(controls, coarse_turn, std::numeric_limits<double>::infinity());
}

Plan fine_plan(const Controls& controls, double rise) {
  double turn = 0;
  double length = 0;
  for (std::size_t i = 0; i + 1 < controls.points.size(); ++i) {
    turn += turn_of(cubic_between(controls.points, i));
    length += length_of(controls.points[i + 1] - controls.points[i]);
  }
  // A blend at the steepest slope turns by at most 8 / 3 radians over a length of its rise.
  const double chord_length = rise * finest_turn * 3 / 8;
  Plan plan = smooth_plan(controls, std::max(finest_turn, turn / most_chords),
                          std::max(chord_length, length / most_chords));
  plan.lengths = lengths_along(plan.points);
  return plan;
}

}  // namespace ribbon

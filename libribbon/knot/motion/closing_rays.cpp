#include "knot/motion/closing_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angles.h"
#include "geometry/vectors.h"
#include "knot/motion/straight_motion.h"

namespace ribbon {
namespace {

// A ray that is clearer than this may stay. View cones are up to 0.03 rad wider than what is seen,
// so another set of them, of the same frame, still shows such a ray to be clear.
constexpr double comfortable_rad = 0.04;
// Less is no clear view: many times what rounding, or scattering the vertices, turns a ray by.
constexpr double least_rad = 0.005;

// Spread evenly over the sphere (a Fibonacci spiral), in few binary digits, so that they are the
// same everywhere.
std::vector<Eigen::Vector3d> all_directions() {
  constexpr int count = 512;
  const double golden_angle_rad = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> result;
  for (int k = 0; k < count; ++k) {
    const double height = 1 - (2 * k + 1.0) / count;
    const double radius = std::sqrt(1 - height * height);
    const double turn_rad = golden_angle_rad * k;
    const Eigen::Vector3d exact(radius * cosine(turn_rad), radius * sine(turn_rad), height);
    result.push_back(normalised((exact * 4096).array().round().matrix()));
  }
  return result;
}

const std::vector<Eigen::Vector3d>& directions_to_choose_from() {
  static const std::vector<Eigen::Vector3d> result = all_directions();
  return result;
}

Eigen::Index first_column(const Eigen::Matrix3Xd& curve, std::size_t end) {
  return end == 0 ? 0 : curve.cols() - 1;
}

Eigen::Vector3d tip(const Eigen::Matrix3Xd& curve, std::size_t end) {
  return curve.col(first_column(curve, end));
}

// What a ray from an end of `base` sees of `curve`.
void append_curve(const MovingCurve& base, const MovingCurve& curve, std::size_t end,
                  std::vector<ViewCone>& cones) {
  const Eigen::Vector3d eye_before = tip(base.before, end);
  const Eigen::Vector3d eye_now = tip(base.now, end);
  const bool own = &base.before == &curve.before;
  const Eigen::Index own_tip = own ? first_column(curve.before, end) : -1;
  for (Eigen::Index k = 0; k + 1 < curve.before.cols(); ++k) {
    // The edge at the eye itself is seen in one direction, that of its other end.
    const Eigen::Index p = k == own_tip ? k + 1 : k;
    const Eigen::Index q = k + 1 == own_tip ? k : k + 1;
    append_view_cones({curve.before.col(p) - eye_before, curve.before.col(q) - eye_before,
                       curve.now.col(p) - eye_now, curve.now.col(q) - eye_now},
                      cones);
  }
}

// What a ray from an end of `base` sees of the ray from the other end of `curve`: all between the
// direction to where that ray begins and its own direction.
void append_ray(const MovingCurve& base, const MovingCurve& curve, std::size_t end,
                const Eigen::Vector3d& direction, std::vector<ViewCone>& cones) {
  const Eigen::Vector3d before = tip(curve.before, 1 - end) - tip(base.before, end);
  const Eigen::Vector3d now = tip(curve.now, 1 - end) - tip(base.now, end);
  const Eigen::Vector3d on_ray = direction * length_of(before);
  append_view_cones({before, on_ray, now, on_ray}, cones);
}

// All that could come through the rays of an end during a step.
std::vector<ViewCone> in_the_way(const RibbonCurves& before, const RibbonCurves& now,
                                 std::size_t end, const Eigen::Vector3d* other_ray) {
  const MovingCurve centre{before.centre_line, now.centre_line};
  const MovingCurve first{before.first_selvage, now.first_selvage};
  const MovingCurve second{before.second_selvage, now.second_selvage};
  const std::array<std::array<const MovingCurve*, 2>, 3> pairs{
      {{&centre, &centre}, {&first, &second}, {&second, &first}}};
  std::vector<ViewCone> cones;
  for (const auto& [base, curve] : pairs) {
    append_curve(*base, *curve, end, cones);
    if (other_ray != nullptr) append_ray(*base, *curve, end, *other_ray, cones);
  }
  return cones;
}

std::vector<double> clearances_rad(const std::vector<ViewCone>& cones) {
  std::vector<double> result;
  for (const Eigen::Vector3d& direction : directions_to_choose_from())
    result.push_back(clearance_rad(cones, direction));
  return result;
}

struct ClearDirection {
  Eigen::Vector3d unit;
  double clear_rad;
};

// Do the clearances of the two ends alone show that the arc between them is clear?
bool plainly_clear(const ClearDirection& from, const ClearDirection& to) {
  const double arc_rad = angle_between_units(from.unit, to.unit);
  return from.clear_rad > least_rad && to.clear_rad > least_rad &&
         arc_rad + least_rad < from.clear_rad + to.clear_rad;
}

// Is the whole arc clear, looking at directions in between where needed?
bool arc_is_clear(const ClearDirection& from, const ClearDirection& to,
                  const std::vector<ViewCone>& cones, int splits_left) {
  if (from.clear_rad <= least_rad || to.clear_rad <= least_rad) return false;
  if (plainly_clear(from, to)) return true;
  if (splits_left == 0) return false;
  const Eigen::Vector3d unit = normalised(from.unit + to.unit);
  const ClearDirection middle{unit, clearance_rad(cones, unit)};
  return arc_is_clear(from, middle, cones, splits_left - 1) &&
         arc_is_clear(middle, to, cones, splits_left - 1);
}

// Which directions can a ray be turned to, arc by arc, without meeting anything? The first arc,
// which may lead out of a narrow gap, is looked at closely.
std::vector<bool> reachable(const Eigen::Vector3d& start, const std::vector<ViewCone>& cones) {
  constexpr int most_splits = 5;
  std::vector<ClearDirection> goals;
  for (const Eigen::Vector3d& direction : directions_to_choose_from())
    goals.push_back({direction, clearance_rad(cones, direction)});
  const ClearDirection from{start, clearance_rad(cones, start)};
  std::vector<bool> result(goals.size());
  std::vector<std::size_t> reached;
  const auto reach = [&](const auto& is_clear) {
    for (std::size_t k = 0; k < goals.size(); ++k) {
      if (result[k] || !is_clear(goals[k])) continue;
      result[k] = true;
      reached.push_back(k);
    }
  };
  reach([&](const ClearDirection& to) { return arc_is_clear(from, to, cones, most_splits); });
  while (!reached.empty()) {
    const ClearDirection& next = goals[reached.back()];
    reached.pop_back();
    reach([&](const ClearDirection& to) { return plainly_clear(next, to); });
  }
  return result;
}

}  // namespace

void ClosingRays::choose(std::size_t end, const std::vector<ViewCone>& cones) {
  const std::vector<double> clear_rad = clearances_rad(cones);
  const auto clearest = std::max_element(clear_rad.begin(), clear_rad.end());
  buried_[end] = *clearest <= comfortable_rad;
  directions_[end] = directions_to_choose_from()[clearest - clear_rad.begin()];
}

void ClosingRays::turn(std::size_t end, const std::vector<ViewCone>& before,
                       const std::vector<ViewCone>& until_now) {
  const std::vector<bool> can_be_reached = reachable(directions_[end], before);
  std::vector<double> clear_rad = clearances_rad(until_now);
  for (std::size_t k = 0; k < clear_rad.size(); ++k)
    if (!can_be_reached[k]) clear_rad[k] = 0;
  const auto clearest = std::max_element(clear_rad.begin(), clear_rad.end());
  if (*clearest <= comfortable_rad) {
    buried_[end] = true;
  } else {
    directions_[end] = directions_to_choose_from()[clearest - clear_rad.begin()];
  }
}

void ClosingRays::start(const RibbonCurves& curves) {
  choose(0, in_the_way(curves, curves, 0, nullptr));
  choose(1, in_the_way(curves, curves, 1, &directions_[0]));
}

void ClosingRays::follow(const RibbonCurves& before, const RibbonCurves& now) {
  // The last end comes after the first and sees its new ray, so in the end both are clear of each
  // other.
  for (const std::size_t end : {0U, 1U}) {
    if (any_buried()) return;
    const Eigen::Vector3d other_ray = directions_[1 - end];
    const std::vector<ViewCone> until_now = in_the_way(before, now, end, &other_ray);
    if (clearance_rad(until_now, directions_[end]) > comfortable_rad) continue;
    turn(end, in_the_way(before, before, end, &other_ray), until_now);
  }
}

}  // namespace ribbon

#include "knot/motion/view_cones.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angles.h"
#include "geometry/vectors.h"

namespace ribbon {

double angle_between_units(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double cosine = std::clamp(dot(a, b), -1.0, 1.0);
  return polar_angle(cosine, std::sqrt(1 - cosine * cosine));
}

namespace {

ViewCone cone_around(const SweptEdge& swept) {
  const Eigen::Vector3d middle =
      normalised(swept[0]) + normalised(swept[1]) + normalised(swept[2]) + normalised(swept[3]);
  ViewCone result{normalised(middle), 0};
  for (const Eigen::Vector3d& corner : swept)
    result.half_angle_rad =
        std::max(result.half_angle_rad, angle_between_units(result.axis, normalised(corner)));
  // Only within a half space do the corners bound the directions in between.
  if (result.half_angle_rad > 1.5) result.half_angle_rad = std::numbers::pi;
  return result;
}

bool is_a_point(const SweptEdge& swept) {
  return std::all_of(swept.begin(), swept.end(),
                     [&](const Eigen::Vector3d& corner) { return corner == swept[0]; });
}

double extent(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  return squared_length_of(one - other);
}

// Halves the swept surface across its longer side: the edge, or the way that it goes.
std::array<SweptEdge, 2> halves(const SweptEdge& swept) {
  const auto& [p_before, q_before, p_after, q_after] = swept;
  const double edge = std::max(extent(p_before, q_before), extent(p_after, q_after));
  const double way = std::max(extent(p_before, p_after), extent(q_before, q_after));
  if (edge > way) {
    const Eigen::Vector3d before = (p_before + q_before) / 2;
    const Eigen::Vector3d after = (p_after + q_after) / 2;
    return {{{p_before, before, p_after, after}, {before, q_before, after, q_after}}};
  }
  const Eigen::Vector3d p = (p_before + p_after) / 2;
  const Eigen::Vector3d q = (q_before + q_after) / 2;
  return {{{p_before, q_before, p, q}, {p, q, p_after, q_after}}};
}

void append(const SweptEdge& swept, int splits_left, std::vector<ViewCone>& cones) {
  constexpr double narrow_rad = 0.03;
  const ViewCone cone = cone_around(swept);
  if (cone.half_angle_rad <= narrow_rad || splits_left == 0 || is_a_point(swept)) {
    cones.push_back(cone);
    return;
  }
  for (const SweptEdge& half : halves(swept)) append(half, splits_left - 1, cones);
}

}  // namespace

void append_view_cones(const SweptEdge& swept, std::vector<ViewCone>& cones) {
  constexpr int most_splits = 10;
  append(swept, most_splits, cones);
}

double clearance_rad(const std::vector<ViewCone>& cones, const Eigen::Vector3d& direction) {
  // Most cones are told to be no nearer by the chord, which is no longer than the angle.
  constexpr double rounding = 1e-12;
  double result = std::numbers::pi;
  for (const ViewCone& cone : cones) {
    const double reach_rad = result + cone.half_angle_rad;
    const double squared_chord = 2 - 2 * dot(direction, cone.axis);
    if (squared_chord > reach_rad * reach_rad + rounding) continue;
    result = std::min(result, angle_between_units(direction, cone.axis) - cone.half_angle_rad);
  }
  return result;
}

}  // namespace ribbon

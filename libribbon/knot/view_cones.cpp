#include "knot/view_cones.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ribbon {
namespace {

double angle_rad(const Eigen::Vector3d& unit_a, const Eigen::Vector3d& unit_b) {
  return std::acos(std::clamp(unit_a.dot(unit_b), -1.0, 1.0));
}

ViewCone cone_around(const SweptEdge& swept) {
  const Eigen::Vector3d middle =
      swept[0].normalized() + swept[1].normalized() + swept[2].normalized() + swept[3].normalized();
  ViewCone result{middle.normalized(), 0};
  for (const Eigen::Vector3d& corner : swept)
    result.half_angle_rad =
        std::max(result.half_angle_rad, angle_rad(result.axis, corner.normalized()));
  // Only within a half space do the corners bound the directions in between.
  if (result.half_angle_rad > 1.5) result.half_angle_rad = std::numbers::pi;
  return result;
}

// The quarter of the swept surface at the given corner.
SweptEdge quarter(const SweptEdge& swept, std::size_t corner) {
  const Eigen::Vector3d centre = (swept[0] + swept[1] + swept[2] + swept[3]) / 4;
  SweptEdge result;
  for (std::size_t other = 0; other < 4; ++other)
    result[other] = (swept[corner] + swept[other]) / 2;
  result[3 - corner] = centre;
  return result;
}

void append(const SweptEdge& swept, int splits_left, std::vector<ViewCone>& cones) {
  constexpr double narrow_rad = 0.1;
  const ViewCone cone = cone_around(swept);
  if (cone.half_angle_rad <= narrow_rad || splits_left == 0) {
    cones.push_back(cone);
    return;
  }
  for (std::size_t corner = 0; corner < 4; ++corner)
    append(quarter(swept, corner), splits_left - 1, cones);
}

}  // namespace

void append_view_cones(const SweptEdge& swept, std::vector<ViewCone>& cones) {
  constexpr int most_splits = 5;
  append(swept, most_splits, cones);
}

double clearance_rad(const std::vector<ViewCone>& cones, const Eigen::Vector3d& direction) {
  double result = std::numbers::pi;
  for (const ViewCone& cone : cones)
    result = std::min(result, angle_rad(direction, cone.axis) - cone.half_angle_rad);
  return result;
}

}  // namespace ribbon

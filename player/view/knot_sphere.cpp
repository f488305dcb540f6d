#include "player/view/knot_sphere.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/row_middles.h"

namespace ribbon {

namespace {

constexpr float near_widths =
    1.2F;  // between the middles of rows that lie on each other, or soon will
constexpr float apart_widths = 2.5F;  // along the ribbon, or they are neighbours
constexpr double bell_deviation_s = 0.25;
constexpr double reach_s = 3 * bell_deviation_s;  // what is farther away counts for nothing

// Marks the rows whose middles come near each other. Sorted along the longest side, each is
// compared with the few that follow.
std::vector<bool> rows_near_others(const Eigen::Matrix3Xf& middles, float near_m, int neighbours) {
  Eigen::Index axis = 0;
  (middles.rowwise().maxCoeff() - middles.rowwise().minCoeff()).maxCoeff(&axis);
  std::vector<int> order(middles.cols());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return middles(axis, a) < middles(axis, b); });
  std::vector<bool> near_another(order.size(), false);
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const auto difference = middles.col(order[b]) - middles.col(order[a]);
      if (difference[axis] > near_m) break;
      if (std::abs(order[a] - order[b]) <= neighbours) continue;
      if (difference.squaredNorm() < near_m * near_m)
        near_another[order[a]] = near_another[order[b]] = true;
    }
  return near_another;
}

}  // namespace

std::optional<Sphere> knot_sphere(const RibbonGrid& grid, float width_m, float length_m,
                                  const Eigen::Matrix3Xf& positions) {
  const float spacing = length_m / static_cast<float>(grid.along - 1);
  const auto neighbours = static_cast<int>(
      std::min(std::ceil(apart_widths * width_m / spacing), static_cast<float>(grid.along)));
  const std::vector<bool> near_another =
      rows_near_others(row_middles(grid, positions), near_widths * width_m, neighbours);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Eigen::Vector3f low = Eigen::Vector3f::Constant(infinity);
  Eigen::Vector3f high = -low;
  for (int i = 0; i < grid.along; ++i) {
    if (!near_another[i]) continue;
    const auto row = positions.middleCols(grid.particle(i, 0), grid.across);
    low = low.cwiseMin(row.rowwise().minCoeff());
    high = high.cwiseMax(row.rowwise().maxCoeff());
  }
  if (!(low.x() <= high.x())) return std::nullopt;
  return Sphere{(low + high) / 2, (high - low).norm() / 2};
}

void FollowedKnot::add(double time_s, const std::optional<Sphere>& sphere) {
  const std::size_t frame = times_s_.size();
  times_s_.push_back(time_s);
  spheres_.push_back(last_known_ ? spheres_[*last_known_] : Eigen::Vector4d::Zero());
  if (!sphere) return;
  const Eigen::Vector4d value(sphere->center.x(), sphere->center.y(), sphere->center.z(),
                              sphere->radius_m);
  const std::size_t before = last_known_.value_or(0);
  const Eigen::Vector4d start = last_known_ ? spheres_[before] : value;
  for (std::size_t gap = last_known_ ? before + 1 : 0; gap < frame; ++gap) {
    const double share = (times_s_[gap] - times_s_[before]) / (time_s - times_s_[before]);
    spheres_[gap] = start + share * (value - start);
  }
  spheres_[frame] = value;
  last_known_ = frame;
}

bool FollowedKnot::is_settled(int frame) const {
  return has_ended_ || (last_known_ && times_s_[*last_known_] >=
                                           times_s_[static_cast<std::size_t>(frame)] + reach_s);
}

std::optional<Sphere> FollowedKnot::at(int frame) const {
  if (!last_known_) return std::nullopt;
  const double time_s = times_s_[static_cast<std::size_t>(frame)];
  auto first = static_cast<std::size_t>(frame);
  while (first > 0 && times_s_[first - 1] >= time_s - reach_s) --first;
  double weights = 0;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (std::size_t f = first; f < times_s_.size() && times_s_[f] <= time_s + reach_s; ++f) {
    const double away = (times_s_[f] - time_s) / bell_deviation_s;
    const double weight = std::exp(-away * away / 2);
    weights += weight;
    sum += weight * spheres_[f];
  }
  const Eigen::Vector4f mean = (sum / weights).cast<float>();
  return Sphere{mean.head<3>(), mean[3]};
}

}  // namespace ribbon

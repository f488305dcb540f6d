#include "player/view/knot_sphere.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace ribbon {

namespace {

constexpr float near_widths =
    1.2F;  // between the middles of rows that lie on each other, or soon will
constexpr float apart_widths = 2.5F;  // along the ribbon, or they are neighbours
constexpr double bell_deviation_s = 0.25;
constexpr double bell_reach = 3;  // deviations; beyond it counts for nothing

Eigen::Matrix3Xf row_middles(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions) {
  Eigen::Matrix3Xf middles(3, grid.along);
  for (int i = 0; i < grid.along; ++i)
    middles.col(i) = positions.middleCols(grid.particle(i, 0), grid.across).rowwise().mean();
  return middles;
}

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

// Centre and radius of every frame; between two that are known they change evenly, before the first
// and after the last they stay.
std::vector<Eigen::Vector4d> filled(const std::vector<double>& times_s,
                                    const std::vector<std::optional<Sphere>>& spheres) {
  std::vector<Eigen::Vector4d> values(spheres.size());
  std::optional<std::size_t> before;
  for (std::size_t f = 0; f < spheres.size(); ++f) {
    if (!spheres[f]) continue;
    values[f] << spheres[f]->center.cast<double>(), spheres[f]->radius_m;
    for (std::size_t gap = before ? *before + 1 : 0; gap < f; ++gap) {
      const double share =
          before ? (times_s[gap] - times_s[*before]) / (times_s[f] - times_s[*before]) : 1;
      values[gap] = before
                        ? Eigen::Vector4d(values[*before] + share * (values[f] - values[*before]))
                        : values[f];
    }
    before = f;
  }
  assert(before);
  std::fill(values.begin() + static_cast<std::ptrdiff_t>(*before), values.end(), values[*before]);
  return values;
}

}  // namespace

std::optional<Sphere> knot_sphere(const RibbonGrid& grid, float width_m, float length_m,
                                  const Eigen::Matrix3Xf& positions) {
  const float spacing = length_m / static_cast<float>(grid.along - 1);
  const auto neighbours = static_cast<int>(std::ceil(apart_widths * width_m / spacing));
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

std::vector<Sphere> followed(const std::vector<double>& times_s,
                             const std::vector<std::optional<Sphere>>& spheres) {
  assert(times_s.size() == spheres.size());
  const std::vector<Eigen::Vector4d> whole = filled(times_s, spheres);
  std::vector<Sphere> result;
  std::size_t first = 0;  // of the frames within reach
  for (const double time_s : times_s) {
    while (times_s[first] < time_s - bell_reach * bell_deviation_s) ++first;
    double weights = 0;
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (std::size_t f = first; f < times_s.size(); ++f) {
      const double away = (times_s[f] - time_s) / bell_deviation_s;
      if (away > bell_reach) break;
      const double weight = std::exp(-away * away / 2);
      weights += weight;
      sum += weight * whole[f];
    }
    const Eigen::Vector4f mean = (sum / weights).cast<float>();
    result.push_back({mean.head<3>(), mean[3]});
  }
  return result;
}

}  // namespace ribbon

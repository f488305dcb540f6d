#include "scene/width_profile.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>

#include "scene/scene.h"

namespace ribbon {

namespace {

// Metres per share, of the straight line from a point to the next.
double secant(const std::vector<WidthAt>& points, std::size_t i) {
  return (points[i + 1].width_m - points[i].width_m) / (points[i + 1].share - points[i].share);
}

// Of the cubics at a point: a weighted harmonic mean of the secants beside it, 0 where the width
// turns round.
double slope(const std::vector<WidthAt>& points, std::size_t i) {
  if (i == 0) return secant(points, 0);
  if (i + 1 == points.size()) return secant(points, i - 1);
  const double before = secant(points, i - 1);
  const double after = secant(points, i);
  if (before * after <= 0) return 0;
  const double reach_before = points[i].share - points[i - 1].share;
  const double reach_after = points[i + 1].share - points[i].share;
  const double weight_before = reach_before + 2 * reach_after;
  const double weight_after = 2 * reach_before + reach_after;
  return (weight_before + weight_after) / (weight_before / before + weight_after / after);
}

}  // namespace

double width_at_m(const WidthProfile& profile, double share) {
  const std::vector<WidthAt>& points = profile.points;
  assert(points.size() >= 2);
  std::size_t i = 0;
  while (i + 2 < points.size() && points[i + 1].share <= share) ++i;
  const WidthAt& a = points[i];
  const WidthAt& b = points[i + 1];
  const double reach = b.share - a.share;
  const double t = std::clamp((share - a.share) / reach, 0.0, 1.0);
  const double rest = 1 - t;
  return a.width_m * rest * rest * (1 + 2 * t) + b.width_m * t * t * (1 + 2 * rest) +
         reach * t * rest * (slope(points, i) * rest - slope(points, i + 1) * t);
}

double width_at_m(const RibbonScene& ribbon, double share) {
  return ribbon.profile ? width_at_m(*ribbon.profile, share) : ribbon.width_m;
}

std::vector<double> row_widths_m(const RibbonScene& ribbon) {
  std::vector<double> widths_m;
  if (!ribbon.profile) return widths_m;
  for (int row = 0; row < ribbon.along; ++row)
    widths_m.push_back(static_cast<float>(
        width_at_m(*ribbon.profile, static_cast<double>(row) / (ribbon.along - 1))));
  return widths_m;
}

double widest_m(const RibbonScene& ribbon) {
  const std::vector<double> rows_m = row_widths_m(ribbon);
  return rows_m.empty() ? ribbon.width_m : *std::max_element(rows_m.begin(), rows_m.end());
}

double mean_width_m(const RibbonScene& ribbon) {
  if (!ribbon.profile) return ribbon.width_m;
  const std::vector<double> rows_m = row_widths_m(ribbon);
  return std::accumulate(rows_m.begin(), rows_m.end(), 0.0) / ribbon.along;
}

}  // namespace ribbon

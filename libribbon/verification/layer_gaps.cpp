#include "verification/layer_gaps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "verification/feature_distance.h"

namespace ribbon {

namespace {

ClosedBox point_box(const Eigen::Vector3f& point) {
  return {point.array(), point.array()};
}

// From a place to the interval from `begin` to `begin` + 1.
int steps_between(int place, int begin) {
  return std::max({0, begin - place, place - (begin + 1)});
}

}  // namespace

LayerGaps::LayerGaps(TriangleSoup soup, RestSize size, const BoxTree& others)
    : soup_(std::move(soup)),
      size_(std::move(size)),
      ribbon_(soup_, 0, soup_.judged),
      others_(others) {}

LayerGap LayerGaps::at(int particle, double reach_m) const {
  // What is as far away as the reach is found, too.
  const double beyond_m = std::nextafter(reach_m, std::numeric_limits<double>::infinity());
  LayerGap gap{beyond_m, beyond_m};
  const auto is_other_layer = [&](int triangle, double distance_m) {
    return distance_m < rest_distance_m(particle, triangle) / 2;
  };
  approach(ribbon_, ribbon_.root(), particle, is_other_layer, gap.to_ribbon_m);
  if (!others_.empty())
    approach(
        others_, others_.root(), particle, [](int, double) { return true; }, gap.to_obstacle_m);
  for (double* found : {&gap.to_ribbon_m, &gap.to_obstacle_m})
    if (*found == beyond_m) *found = std::numeric_limits<double>::infinity();
  return gap;
}

// Lowers nearest_m to the distance of the nearest triangle below the node that counts.
template <class Counts>
void LayerGaps::approach(const BoxTree& tree, const BoxTree::Node& node, int particle,
                         const Counts& counts, double& nearest_m) const {
  const Eigen::Vector3f point = soup_.points.col(particle);
  const ClosedBox box = point_box(point);
  // The factor covers the rounding of the squared distances.
  const auto is_farther = [&](const ClosedBox& other) {
    return box.squared_distance(other) > nearest_m * nearest_m * (1 + 1e-12);
  };
  if (is_farther(node.box)) return;
  if (!node.is_leaf()) {
    for (const int half : tree.nearest_half_first(node, box))
      approach(tree, tree.node(half), particle, counts, nearest_m);
    return;
  }
  for (const int triangle : tree.triangles(node)) {
    if (!counts(triangle, 0) || is_farther(ClosedBox::around(soup_, triangle))) continue;
    const double distance_m =
        certain_point_triangle_distance(point, soup_.corner(triangle, 0), soup_.corner(triangle, 1),
                                        soup_.corner(triangle, 2), nearest_m);
    if (distance_m < nearest_m && counts(triangle, distance_m)) nearest_m = distance_m;
  }
}

// To the quad of the triangle.
double LayerGaps::rest_distance_m(int particle, int triangle) const {
  const RibbonGrid& grid = size_.grid;
  const int quad = triangle / 2;
  return std::hypot(size_.along_m() * steps_between(grid.row(particle), quad / (grid.across - 1)),
                    rest_across_m(particle, quad));
}

// To its columns; at least, where these are no parallels.
double LayerGaps::rest_across_m(int particle, int quad) const {
  const RibbonGrid& grid = size_.grid;
  if (!size_.has_profile())
    return size_.across_m() * steps_between(grid.column(particle), quad % (grid.across - 1));
  const auto across_m = [this](int corner) { return size_.place_m(corner).y(); };
  const auto [a, b, c, d] = grid.quad(quad);
  const double place_m = across_m(particle);
  return std::max({0.0, std::min(across_m(a), across_m(b)) - place_m,
                   place_m - std::max(across_m(c), across_m(d))});
}

}  // namespace ribbon

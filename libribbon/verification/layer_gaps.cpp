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

LayerGaps::LayerGaps(TriangleSoup soup, const RibbonGrid& grid, double length_m, double width_m,
                     const BoxTree& rest)
    : soup_(std::move(soup)),
      grid_(grid),
      along_m_(length_m / (grid.along - 1)),
      across_m_(width_m / (grid.across - 1)),
      ribbon_(soup_, 0, soup_.judged),
      rest_(rest) {}

LayerGap LayerGaps::at(int particle, double reach_m) const {
  // What is as far away as the reach is found, too.
  const double beyond_m = std::nextafter(reach_m, std::numeric_limits<double>::infinity());
  LayerGap gap{beyond_m, beyond_m};
  const auto is_other_layer = [&](int triangle, double distance_m) {
    return distance_m < rest_distance_m(particle, triangle) / 2;
  };
  approach(ribbon_, ribbon_.root(), particle, is_other_layer, gap.to_ribbon_m);
  if (!rest_.empty())
    approach(
        rest_, rest_.root(), particle, [](int, double) { return true; }, gap.to_obstacle_m);
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
  const int quad = triangle / 2;
  return std::hypot(along_m_ * steps_between(grid_.row(particle), quad / (grid_.across - 1)),
                    across_m_ * steps_between(grid_.column(particle), quad % (grid_.across - 1)));
}

}  // namespace ribbon

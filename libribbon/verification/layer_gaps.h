// How far is it from a particle to the next layer of cloth, and to the obstacle?
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"
#include "verification/box_tree.h"
#include "verification/triangle_soup.h"

namespace ribbon {

// In metres, infinite where there is nothing within reach. Never larger than the truth, and short
// of it by rounding only.
struct LayerGap {
  double to_ribbon_m;
  double to_obstacle_m;
};

// Of one frame. What lies near in the flat ribbon is no other layer: a place of the ribbon counts
// as one where it is less than half as far away as it is at rest.
class LayerGaps {
 public:
  // The judged triangles of `soup`, whose points must be finite, are those of `grid` that is at
  // rest length_m x width_m; `rest` is a tree of the others and must outlive this.
  LayerGaps(TriangleSoup soup, const RibbonGrid& grid, double length_m, double width_m,
            const BoxTree& rest);

  // May be called from several threads at a time.
  [[nodiscard]] LayerGap at(int particle, double reach_m) const;

 private:
  template <class Counts>
  void approach(const BoxTree& tree, const BoxTree::Node& node, int particle, const Counts& counts,
                double& nearest_m) const;
  [[nodiscard]] double rest_distance_m(int particle, int triangle) const;

  TriangleSoup soup_;
  RibbonGrid grid_;
  double along_m_;   // between rows at rest
  double across_m_;  // between columns
  BoxTree ribbon_;
  const BoxTree& rest_;
};

}  // namespace ribbon

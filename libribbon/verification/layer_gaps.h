// How far is it from a particle to the next layer of cloth, and to the obstacle?
#pragma once

#include <Eigen/Core>

#include "geometry/rest_size.h"
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
  // The judged triangles of `soup`, whose points must be finite, are those of a ribbon of that
  // size; `others` is a tree of the others and must outlive this.
  LayerGaps(TriangleSoup soup, RestSize size, const BoxTree& others);

  // May be called from several threads at a time.
  [[nodiscard]] LayerGap at(int particle, double reach_m) const;

 private:
  template <class Counts>
  void approach(const BoxTree& tree, const BoxTree::Node& node, int particle, const Counts& counts,
                double& nearest_m) const;
  [[nodiscard]] double rest_distance_m(int particle, int triangle) const;
  [[nodiscard]] double rest_across_m(int particle, int quad) const;

  TriangleSoup soup_;
  RestSize size_;
  BoxTree ribbon_;
  const BoxTree& others_;
};

}  // namespace ribbon

#include "simulation/swept_pairs.h"

#include "simulation/vertex_ranges.h"

namespace ribbon {

namespace {

// The ribbon has been refitted to `ranges`, grown by margin_m: the boxes of both
// partners are grown, the still obstacle's is not, so the whole margin serves both.
std::vector<FeaturePair> list_pairs(const Bodies& bodies, Hierarchy::Spare spare,
                                    std::span<const Box> ranges, double margin_m) {
  const Body& ribbon = bodies.ribbon;
  const RangedSurface band{ribbon.surface, ranges, ribbon.boxes};
  std::vector<FeaturePair> pairs =
      feature_pairs(band, band, ribbon.hierarchy.pairs_within(spare), margin_m);
  if (bodies.obstacle) {
    const Body& obstacle = *bodies.obstacle;
    const std::vector<FeaturePair> with_obstacle =
        feature_pairs(band, {obstacle.surface, ranges, obstacle.boxes},
                      ribbon.hierarchy.pairs_with(obstacle.hierarchy), margin_m);
    pairs.insert(pairs.end(), with_obstacle.begin(), with_obstacle.end());
  }
  return pairs;
}

}  // namespace

std::vector<FeaturePair> pairs_within_ranges(Bodies& bodies, std::span<const Box> ranges,
                                             double margin_m) {
  bodies.ribbon.refit(ranges, margin_m);
  return list_pairs(bodies, Hierarchy::Spare::boxes, ranges, margin_m);
}

std::vector<FeaturePair> swept_pairs_by_curvature(Bodies& bodies, const Eigen::Matrix3Xd& t0,
                                                  const Eigen::Matrix3Xd& t1, double margin_m) {
  const std::vector<Box> ranges = vertex_ranges(t0, t1);
  bodies.ribbon.refit(ranges, margin_m);
  bodies.ribbon.hierarchy.refit_curvatures(t0, t1);
  return list_pairs(bodies, Hierarchy::Spare::curvature_and_boxes, ranges, margin_m);
}

}  // namespace ribbon

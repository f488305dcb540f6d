#include "simulation/swept_pairs.h"

namespace ribbon {

std::vector<FeaturePair> swept_pairs(Bodies& bodies, Hierarchy::Spare spare,
                                     const Eigen::Matrix3Xd& t0, const Eigen::Matrix3Xd& t1,
                                     double margin_m) {
  Body& ribbon = bodies.ribbon;
  // The boxes of both partners are grown, the still obstacle's is not: the whole margin serves
  // both.
  ribbon.hierarchy.refit(t0, t1, margin_m);
  std::vector<FeaturePair> pairs = feature_pairs(
      ribbon.surface, ribbon.surface, ribbon.hierarchy.pairs_within(spare), t0, t1, margin_m);
  if (bodies.obstacle) {
    const std::vector<FeaturePair> with_obstacle =
        feature_pairs(ribbon.surface, bodies.obstacle->surface,
                      ribbon.hierarchy.pairs_with(bodies.obstacle->hierarchy), t0, t1, margin_m);
    pairs.insert(pairs.end(), with_obstacle.begin(), with_obstacle.end());
  }
  return pairs;
}

}  // namespace ribbon

#include "simulation/detection/swept_pairs.h"

#include <optional>

#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

namespace {

std::vector<FeaturePair> list_pairs(Bodies& bodies, std::span<const CandidatePair> within,
                                    std::span<const CandidatePair> with_obstacle,
                                    std::span<const MovingBox> ranges, double margin_m) {
  const RangedSurface band{bodies.ribbon.surface(), ranges, 0};
  std::vector<FeaturePair> pairs = feature_pairs(band, band, within, margin_m);
  if (bodies.obstacle) {
    const ObstacleBody& obstacle = *bodies.obstacle;
    const std::vector<MovingBox> still = vertex_ranges(obstacle.vertices, obstacle.vertices);
    const std::vector<FeaturePair> others = feature_pairs(
        band, {obstacle.surface, still, bodies.grid.particle_count()}, with_obstacle, margin_m);
    pairs.insert(pairs.end(), others.begin(), others.end());
  }
  return pairs;
}

void list_by(RibbonBvh& patches, const std::optional<ObstacleBody>& obstacle,
             std::vector<FeaturePair>& pairs) {
  pairs.clear();
  patches.list_within(pairs);
  if (obstacle) patches.list_with(obstacle->surface, obstacle->bvh, obstacle->vertices, pairs);
}

}  // namespace

void list_pairs_within_ranges(Bodies& bodies, std::span<const MovingBox> ranges, double margin_m,
                              std::vector<FeaturePair>& pairs) {
  bodies.ribbon_bvh.refit(ranges, margin_m);
  list_by(bodies.ribbon_bvh, bodies.obstacle, pairs);
}

void list_pairs_of_changed_ranges(std::span<const int> particles, Bodies& bodies,
                                  std::span<const MovingBox> ranges,
                                  std::vector<FeaturePair>& pairs) {
  bodies.ribbon_bvh.refit_around(particles, ranges);
  list_by(bodies.ribbon_bvh, bodies.obstacle, pairs);
}

std::vector<FeaturePair> swept_pairs_by_curvature(Bodies& bodies, const Eigen::Matrix3Xd& t0,
                                                  const Eigen::Matrix3Xd& t1, double margin_m) {
  const std::vector<MovingBox> ranges = vertex_ranges(t0, t1);
  TriangleBvh& ribbon = bodies.ribbon.triangle_bvh(t0);
  // The boxes of both partners are grown, the still obstacle's is not: the whole margin serves
  // both.
  ribbon.refit(ranges, margin_m);
  ribbon.refit_curvatures(t0, t1);
  std::vector<CandidatePair> with_obstacle;
  if (bodies.obstacle) with_obstacle = ribbon.pairs_with(bodies.obstacle->bvh);
  return list_pairs(bodies, ribbon.pairs_within(TriangleBvh::Spare::curvature_and_boxes),
                    with_obstacle, ranges, margin_m);
}

}  // namespace ribbon

// The one place that knows how the product detects: what changes there is followed here.
#include <memory>
#include <optional>
#include <vector>

#include "benchmarks/solver/detector.h"
#include "benchmarks/solver/space_enumeration.h"
#include "simulation/detection/bodies.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon {
namespace {

using Pairs = std::vector<FeaturePair>;

// A ribbon that moves, and how the product keeps it between the steps of a run.
struct Moving {
  const RibbonMotion& motion;
  Bodies bodies{motion.grid, std::nullopt};

  [[nodiscard]] std::vector<MovingBox> ranges() const {
    return vertex_ranges(motion.t0, motion.t1);
  }
};

// The features of the triangles whose grown boxes meet, as pairs_of(boxes) finds these, listed as
// the product does.
template <class PairsOf>
Pairs by_triangles(Moving& moving, const PairsOf& pairs_of) {
  RibbonBody& body = moving.bodies.ribbon;
  const std::vector<MovingBox> ranges = moving.ranges();
  std::vector<MovingBox> grown;
  for (const auto& triangle : body.surface().triangles.colwise()) {
    grown.push_back(ranges[triangle[0]]);
    grown.back().include(ranges[triangle[1]]);
    grown.back().include(ranges[triangle[2]]);
    grown.back().grow(moving.motion.margin_m / 2);
  }
  const RangedSurface surface{body.surface(), ranges};
  return feature_pairs(surface, surface, pairs_of(grown), moving.motion.margin_m);
}

std::vector<CandidatePair> each_against_each(const std::vector<MovingBox>& boxes) {
  std::vector<CandidatePair> found;
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = a + 1; b < boxes.size(); ++b)
      if (boxes[a].meets(boxes[b])) found.push_back({static_cast<int>(a), static_cast<int>(b)});
  return found;
}

// Cells hold what reaches into them at any time of the step.
std::vector<CandidatePair> in_a_cell(const std::vector<MovingBox>& boxes, double cell_factor) {
  double sizes_m = 0;
  std::vector<Box> swept;
  for (const MovingBox& box : boxes) {
    swept.push_back(box.start);
    swept.back().include(box.end);
    sizes_m += (swept.back().high - swept.back().low).maxCoeff();
  }
  return pairs_by_cells(swept, cell_factor * sizes_m / static_cast<double>(boxes.size()));
}

Pairs by_boxes(Moving& moving) {
  RibbonBody& body = moving.bodies.ribbon;
  const std::vector<MovingBox> ranges = moving.ranges();
  TriangleBvh& bvh = body.triangle_bvh(moving.motion.t0);
  bvh.refit(ranges, moving.motion.margin_m / 2);
  const RangedSurface surface{body.surface(), ranges};
  return feature_pairs(surface, surface, bvh.pairs_within(TriangleBvh::Spare::boxes),
                       moving.motion.margin_m);
}

Pairs detect(DetectionMethod method, double cell_factor, Moving& moving) {
  const RibbonMotion& motion = moving.motion;
  switch (method) {
    case DetectionMethod::brute_force:
      return by_triangles(moving, each_against_each);
    case DetectionMethod::space_enumeration:
      return by_triangles(moving, [&](const auto& boxes) { return in_a_cell(boxes, cell_factor); });
    case DetectionMethod::curvature:
      return swept_pairs_by_curvature(moving.bodies, motion.t0, motion.t1, motion.margin_m);
    case DetectionMethod::boxes:
      return by_boxes(moving);
    case DetectionMethod::patches: {
      Pairs pairs;
      list_pairs_within_ranges(moving.bodies, moving.ranges(), motion.margin_m, pairs);
      return pairs;
    }
  }
  return {};
}

}  // namespace

Detector make_detector(DetectionMethod method, const RibbonMotion& motion, double cell_factor) {
  return [=, moving = std::make_shared<Moving>(Moving{motion})] {
    return detect(method, cell_factor, *moving);
  };
}

}  // namespace ribbon

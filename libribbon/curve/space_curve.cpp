// Everything up to the last step happens in drawing units, so that an error can name a place that
// the user finds in the drawing.
#include "curve/space_curve.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curve/axis_view.h"
#include "curve/place.h"
#include "curve/smooth_plan.h"
#include "curve/walk_levels.h"
#include "geometry/lengths_along.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;

Result<void> same_crossings(const std::vector<DoublePoint>& drawn, const Controls& controls) {
  const Plan plan = coarse_plan(controls);
  const auto smooth = find_double_points(plan.points);
  const std::string remedy = "draw more points there, or the strands further apart";
  if (!smooth)
    return failure(smooth.error().place, "once smoothed, " + smooth.error().problem, remedy);
  const double near = 1e-3 * extent_of(plan.points);
  for (std::size_t i = 0; i < std::max(drawn.size(), smooth->size()); ++i) {
    if (i < drawn.size() && i < smooth->size() &&
        length_of(drawn[i].point - (*smooth)[i].point) < near)
      continue;
    return failure(drawing_place(i < smooth->size() ? (*smooth)[i].point : drawn[i].point),
                   "the smoothed curve crosses itself otherwise than the drawing", remedy);
  }
  return {};
}

Eigen::Matrix3Xd evenly_sampled(const std::vector<Vector3d>& points,
                                const std::vector<double>& lengths, int samples) {
  Eigen::Matrix3Xd result(3, samples);
  std::size_t i = 0;
  for (int k = 0; k < samples; ++k) {
    const double length = lengths.back() * k / (samples - 1);
    while (i + 2 < points.size() && lengths[i + 1] < length) ++i;
    const double t = std::clamp((length - lengths[i]) / (lengths[i + 1] - lengths[i]), 0.0, 1.0);
    result.col(k) = points[i] + t * (points[i + 1] - points[i]);
  }
  return result;
}

// What the drawing holds, as a line in space.
struct WalkedDrawing {
  std::vector<Crossing> crossings;
  WalkedPassages passages;
  Controls controls;
};

Result<WalkedDrawing> walked_drawing(const CurveScene& scene, const ObjectHeights& object) {
  const auto drawing = read_drawing(scene);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto points = find_double_points(drawing->points);
  if (!points) return tl::unexpected(points.error());
  auto objects = object_passages(*points, *drawing, scene, object);
  if (!objects) return tl::unexpected(objects.error());
  auto crossings = over_and_under(*points, *drawing, scene);
  if (!crossings) return tl::unexpected(crossings.error());
  auto passages = passages_along(*crossings);
  Controls controls = controls_of(drawing->points, passages);
  if (auto same = same_crossings(*points, controls); !same) return tl::unexpected(same.error());
  return WalkedDrawing{
      *std::move(crossings), {std::move(passages), *std::move(objects)}, std::move(controls)};
}

// Of the room that the widest row would need, each crossing gets what its two strands do, which are
// as wide as at the same share of the plan's length.
void share_gap(double length, const CurveScene& scene, const RibbonScene& ribbon,
               StoppedWalk& walk) {
  if (!ribbon.profile) return;
  const double most_m = widest_m(ribbon) + scene.clearance_m;
  const auto width_m_at = [&](std::size_t stop) {
    return width_at_m(ribbon, walk.stops[stop].length / length);
  };
  for (WalkProfile::Crossing& crossing : walk.profile.crossings) {
    const double mean_m = (width_m_at(crossing.above) + width_m_at(crossing.below)) / 2;
    crossing.share = std::min(1.0, (mean_m + scene.clearance_m) / most_m);
  }
}

struct LiftedPlan {
  std::vector<Vector3d> points;
  std::vector<std::size_t> passages;  // their indices in `points`
  std::optional<Error> squeezed = std::nullopt;
};

Result<LiftedPlan> lifted(const WalkedDrawing& drawn, const CurveScene& scene,
                          const RibbonScene& ribbon, TightPassage tight_passage,
                          const ObjectHeights& object) {
  const double width_m = widest_m(ribbon);
  const auto stops_of = [&](const Plan& plan) {
    return stopped_walk(plan, drawn.passages, object, width_m / 2 / scene.unit_m,
                        scene.clearance_m / 2 / scene.unit_m)
        .map([&](StoppedWalk&& walk) {
          share_gap(plan.lengths.back(), scene, ribbon, walk);
          return std::move(walk);
        });
  };
  const double gap = (width_m + scene.clearance_m) / scene.unit_m;
  Plan plan = fine_plan(drawn.controls, gap);
  auto walk = stops_of(plan);
  if (!walk) return tl::unexpected(walk.error());
  const Heights heights = passage_heights(walk->profile, gap);
  if (!heights.tight)
    return LiftedPlan{raised(plan, walk->stops, heights.passages), std::move(plan.passages)};
  const auto refusal = too_tight(scene, ribbon, *walk, *heights.tight);
  if (tight_passage == TightPassage::refuse || heights.gap <= 0) return refusal;
  plan = fine_plan(drawn.controls, heights.gap);
  walk = stops_of(plan);
  if (!walk) return tl::unexpected(walk.error());
  return LiftedPlan{raised(plan, walk->stops, heights.passages), std::move(plan.passages),
                    refusal.value()};
}

}  // namespace

Result<SpaceCurve> generate_space_curve(const CurveScene& scene, const RibbonScene& ribbon,
                                        TightPassage tight_passage, const ObjectHeights& object) {
  assert(ribbon.along >= 2 && scene.unit_m > 0 && ribbon.width_m > 0 && scene.clearance_m >= 0);
  auto drawn = walked_drawing(scene, object);
  if (!drawn) return tl::unexpected(drawn.error());
  auto plan = lifted(*drawn, scene, ribbon, tight_passage, object);
  if (!plan) return tl::unexpected(plan.error());
  for (Vector3d& point : plan->points) {
    point.head<2>() -= scene.origin;
    point = in_world(point * scene.unit_m, scene.axis);
  }
  const auto lengths = lengths_along(plan->points);
  std::vector<double> passage_shares;
  for (const std::size_t i : plan->passages) passage_shares.push_back(lengths[i] / lengths.back());
  return SpaceCurve{.points = evenly_sampled(plan->points, lengths, ribbon.along),
                    .length_m = lengths.back(),
                    .crossings = std::move(drawn->crossings),
                    .objects = std::move(drawn->passages.objects),
                    .passage_shares = std::move(passage_shares),
                    .squeezed = std::move(plan->squeezed)};
}

}  // namespace ribbon

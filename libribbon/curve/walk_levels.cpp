#include "curve/walk_levels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <optional>

#include "curve/place.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double steepest_slope = 1;  // rise per length in the plan
constexpr double blend_slope = 1.5;   // of the blend below, at its middle, per mean slope
constexpr double gentle_lead = 6;     // length per rise from an end to its first stop

// A run of the plan, by length along it.
struct LevelRun {
  double begin = 0;  // at the outline
  double end = 0;
  HeightRange object;
  double before = 0;  // so far beside the outline it is level, too
  double after = 0;
};

double length_at(const Plan& plan, double parameter) {
  const auto i = std::min(static_cast<std::size_t>(parameter), plan.lengths.size() - 2);
  const double fraction = parameter - static_cast<double>(i);
  return plan.lengths[i] + fraction * (plan.lengths[i + 1] - plan.lengths[i]);
}

// A run must not reach into the next one, nor to an end of the walk, where the curve is in the
// plane.
void widen(std::vector<LevelRun>& runs, double margin, double length) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double last = i > 0 ? runs[i - 1].end : 0;
    const double next = i + 1 < runs.size() ? runs[i + 1].begin : length;
    runs[i].before = std::min(margin, (runs[i].begin - last) / 2);
    runs[i].after = std::min(margin, (next - runs[i].end) / 2);
  }
}

std::size_t passages_before(double parameter, const std::vector<std::size_t>& passages) {
  return static_cast<std::size_t>(
      std::count_if(passages.begin(), passages.end(),
                    [&](std::size_t passage) { return static_cast<double>(passage) < parameter; }));
}

std::size_t passages_before(double parameter, const std::vector<Passage>& passages) {
  return static_cast<std::size_t>(
      std::count_if(passages.begin(), passages.end(),
                    [&](const Passage& passage) { return passage.parameter < parameter; }));
}

tl::unexpected<Error> passes_otherwise(const Vector2d& point) {
  return failure(drawing_place(point), "the smoothed curve passes the object otherwise than drawn",
                 "draw more points there, or the curve farther from the object's outline");
}

Result<std::vector<LevelRun>> level_runs(const Plan& plan, const WalkedPassages& passages,
                                         const ObjectHeights& object) {
  if (passages.objects.empty()) return std::vector<LevelRun>();
  const auto smooth = find_object_runs(plan.points, object);
  if (smooth.size() != passages.objects.size())
    return passes_otherwise(smooth.empty() ? passages.objects.front().run.from
                                           : smooth.back().from);
  std::vector<LevelRun> runs;
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    if (passages_before(smooth[i].begin, plan.passages) !=
        passages_before(passages.objects[i].run.begin, passages.crossings))
      return passes_otherwise(smooth[i].from);
    runs.push_back(
        {length_at(plan, smooth[i].begin), length_at(plan, smooth[i].end), smooth[i].object});
  }
  return runs;
}

// A stop with what it was before all were sorted.
struct LooseStop {
  WalkStop stop;
  std::optional<std::size_t> passage = std::nullopt;  // of a crossing
};

std::vector<LooseStop> loose_stops(const Plan& plan, const WalkedPassages& passages,
                                   const std::vector<LevelRun>& runs) {
  std::vector<LooseStop> stops;
  std::size_t number = 0;
  for (const CountedPassage& passage : counted(passages.crossings, passages.objects)) {
    const std::string name = "passage " + std::to_string(++number);
    const std::size_t i = passage.index;
    if (passage.of_object) {
      const ObjectRun& run = passages.objects[i].run;
      const LevelRun& level = runs[i];
      stops.push_back(
          {{level.begin - level.before, run.from, "the begin of " + name, i, level.before}});
      stops.push_back({{level.end + level.after, run.to, "the end of " + name, i, level.after}});
    } else {
      stops.push_back({{plan.lengths[plan.passages[i]], passages.crossings[i].point, name}, i});
    }
  }
  std::stable_sort(stops.begin(), stops.end(), [](const LooseStop& a, const LooseStop& b) {
    return a.stop.length < b.stop.length;
  });
  return stops;
}

std::vector<double> rises_between(const std::vector<WalkStop>& stops, double length) {
  std::vector<double> rises;
  double before = 0;
  for (const WalkStop& stop : stops) {
    rises.push_back((stop.length - before) * steepest_slope / blend_slope);
    before = stop.length;
  }
  rises.push_back((length - before) * steepest_slope / blend_slope);
  return rises;
}

// All stops from the begin of a run to its end are bound. (Not by their lengths: where one run ends
// the next may begin.)
std::vector<ObjectBound> bounds_of(const std::vector<WalkStop>& stops,
                                   const std::vector<LevelRun>& runs,
                                   const std::vector<ObjectPassage>& objects, double clearance) {
  std::vector<ObjectBound> bounds;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto is_of_run = [i](const WalkStop& stop) { return stop.run == i; };
    const auto begin = std::find_if(stops.begin(), stops.end(), is_of_run);
    const auto end = std::find_if(begin + 1, stops.end(), is_of_run);
    const bool in_front = objects[i].in_front;
    for (auto stop = begin; stop <= end; ++stop)
      bounds.push_back({static_cast<std::size_t>(stop - stops.begin()),
                        in_front ? runs[i].object.high + clearance : runs[i].object.low - clearance,
                        in_front});
  }
  return bounds;
}

// "from the start to passage 1", "from passage 2 to 3", "from passage 6 to the end".
std::string text_of(const Stretch& stretch, const std::vector<WalkStop>& stops) {
  const std::string passage = "passage ";
  const std::string from = stretch.from == 0 ? "the start" : stops[stretch.from - 1].name;
  std::string to = stretch.to == stops.size() ? "the end" : stops[stretch.to].name;
  if (from.starts_with(passage) && to.starts_with(passage)) to.erase(0, passage.size());
  return "from " + from + " to " + to;
}

std::string text_of(const std::vector<Stretch>& stretches, const std::vector<WalkStop>& stops) {
  constexpr std::size_t most = 6;
  const std::size_t told = std::min(stretches.size(), most);
  std::string text = stretches.size() == 1 ? "the way " : "the ways ";
  for (std::size_t i = 0; i < told; ++i) {
    if (i > 0) text += i + 1 == stretches.size() ? " and " : ", ";
    text += text_of(stretches[i], stops);
  }
  const std::size_t rest = stretches.size() - told;
  if (rest > 0) text += " and " + std::to_string(rest) + " more";
  return text;
}

// A stop's height, or that of an end's lead; the curve is level there.
struct Level {
  double length = 0;
  double height = 0;
};

// From one height to the other, level at both. Where passages alternate it is Catmull-Rom's cubic
// again: the levels before and after each are equal, and so its derivative there is 0.
double blend(const Level& a, const Level& b, double length) {
  if (b.length <= a.length) return b.height;
  const double t = std::clamp((length - a.length) / (b.length - a.length), 0.0, 1.0);
  return a.height + (b.height - a.height) * t * t * (3 - 2 * t);
}

std::vector<Level> levels_of(const std::vector<WalkStop>& stops, const std::vector<double>& heights,
                             double length) {
  if (heights.empty()) return {{0, 0}};
  const auto lead = [](double height) { return gentle_lead * std::abs(height); };
  std::vector<Level> levels{{std::max(0.0, stops.front().length - lead(heights.front())), 0}};
  for (std::size_t i = 0; i < heights.size(); ++i) levels.push_back({stops[i].length, heights[i]});
  levels.push_back({std::min(length, levels.back().length + lead(heights.back())), 0});
  return levels;
}

}  // namespace

Result<StoppedWalk> stopped_walk(const Plan& plan, const WalkedPassages& passages,
                                 const ObjectHeights& object, double margin, double clearance) {
  auto runs = level_runs(plan, passages, object);
  if (!runs) return tl::unexpected(runs.error());
  widen(*runs, margin, plan.lengths.back());
  StoppedWalk walk{.stops = {}, .profile = {}, .margin = margin};
  walk.profile.crossings.resize(passages.crossings.size() / 2);
  for (LooseStop& loose : loose_stops(plan, passages, *runs)) {
    if (loose.passage) {
      const Passage& passage = passages.crossings[*loose.passage];
      WalkProfile::Crossing& crossing = walk.profile.crossings[passage.crossing];
      (passage.over ? crossing.above : crossing.below) = walk.stops.size();
    }
    walk.stops.push_back(std::move(loose.stop));
  }
  walk.profile.rises = rises_between(walk.stops, plan.lengths.back());
  walk.profile.bounds = bounds_of(walk.stops, *runs, passages.objects, clearance);
  return walk;
}

namespace {

// Why there is no room without any way that is too short: some crossing's upper strand lies behind
// the object and its lower one in front of it.
tl::unexpected<Error> turned_round(const StoppedWalk& walk) {
  const auto is_bound = [&](std::size_t stop, bool in_front) {
    const auto& bounds = walk.profile.bounds;
    return std::any_of(bounds.begin(), bounds.end(), [&](const ObjectBound& bound) {
      return bound.passage == stop && bound.in_front == in_front;
    });
  };
  const auto& crossings = walk.profile.crossings;
  const auto turned = std::find_if(crossings.begin(), crossings.end(), [&](const auto& crossing) {
    return is_bound(crossing.above, false) && is_bound(crossing.below, true);
  });
  assert(turned != crossings.end());
  const WalkStop& above = walk.stops[turned->above];
  return failure(drawing_place(above.point),
                 above.name + " lies behind the object and " + walk.stops[turned->below].name +
                     ", over which it is to pass, in front of it",
                 "exchange over and under there, or front and behind");
}

// What is added to ways that lead from the margin of one run before or behind the object to that of
// another, so that they are told from outline to outline: the margins as they are, or as they are
// to be.
struct MarginsBeside {
  double present = 0;
  double wanted = 0;
};

MarginsBeside margins_beside(const std::vector<Stretch>& stretches, const StoppedWalk& walk) {
  MarginsBeside margins;
  const auto add = [&](const WalkStop& stop) {
    if (!stop.run) return;
    margins.present += stop.from_outline;
    margins.wanted += walk.margin;
  };
  for (const Stretch& stretch : stretches) {
    if (stretch.from > 0) add(walk.stops[stretch.from - 1]);
    if (stretch.to < walk.stops.size()) add(walk.stops[stretch.to]);
  }
  return margins;
}

}  // namespace

tl::unexpected<Error> too_tight(const CurveScene& scene, const RibbonScene& ribbon,
                                const StoppedWalk& walk, const TightCircle& tight) {
  if (tight.stretches.empty()) return turned_round(walk);
  const double width_m = widest_m(ribbon);
  const bool varies = ribbon.profile.has_value();
  const double gap = (width_m + scene.clearance_m) / scene.unit_m;
  const double length = tight.rise * blend_slope / steepest_slope;
  const double needed =
      length + (gap - tight.gap()) * tight.rise_per_gap() * blend_slope / steepest_slope;
  const MarginsBeside margins = margins_beside(tight.stretches, walk);
  const double most_m = tight.gap() * scene.unit_m - scene.clearance_m;
  const Vector2d place =
      walk.stops[std::min(tight.stretches.front().to, walk.stops.size() - 1)].point;
  const Vector2d metres = (place - scene.origin) * scene.unit_m;
  const bool one = tight.stretches.size() == 1;
  const bool passes_object = tight.bounds > 0;
  constexpr double spare = 1.01;  // so that the numbers hold although they are rounded
  return failure(drawing_place(place) + ", in metres " + coordinates(metres),
                 text_of(tight.stretches, walk.stops) + (one ? " is " : " are together ") +
                     three_digits((length + margins.present) * scene.unit_m) +
                     " m long, too short for a ribbon " + (varies ? "up to " : "") +
                     three_digits(width_m) + " m wide" +
                     (passes_object ? " that passes the object" : ""),
                 std::string(one ? "draw it " : "draw them together ") +
                     three_digits(spare * (needed + margins.wanted)) + " drawing units long" +
                     (most_m > 0 ? std::string(", or set ribbon.width to ") +
                                       (varies ? "at most " : "") + three_digits(most_m / spare)
                                 : "") +
                     (passes_object ? ", or make the object smaller with obstacle.scale" : ""));
}

std::vector<Vector3d> raised(const Plan& plan, const std::vector<WalkStop>& stops,
                             const std::vector<double>& heights) {
  const std::vector<Level> levels = levels_of(stops, heights, plan.lengths.back());
  std::vector<Vector3d> points;
  std::size_t next = 0;
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    while (next + 1 < levels.size() && levels[next].length <= plan.lengths[i]) ++next;
    const Level& before = levels[next == 0 ? 0 : next - 1];
    points.emplace_back(plan.points[i].x(), plan.points[i].y(),
                        blend(before, levels[next], plan.lengths[i]));
  }
  return points;
}

}  // namespace ribbon

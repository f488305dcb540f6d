#include "curve/object_passages.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "curve/place.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;

constexpr double sample_per_extent = 1.0 / 2000;

bool is_of_object(char letter) {
  return letter == 'F' || letter == 'B';
}

// A passage that the list has a letter for.
struct Stop {
  double parameter = 0;
  Vector2d point;
  const ObjectRun* run = nullptr;  // none: the passage of a crossing
};

std::vector<Stop> stops_along(const std::vector<DoublePoint>& points,
                              const std::vector<ObjectRun>& runs) {
  std::vector<Stop> stops;
  for (const DoublePoint& point : points) {
    stops.push_back({point.first, point.point});
    stops.push_back({point.second, point.point});
  }
  for (const ObjectRun& run : runs) stops.push_back({run.begin, run.from, &run});
  std::stable_sort(stops.begin(), stops.end(),
                   [](const Stop& a, const Stop& b) { return a.parameter < b.parameter; });
  return stops;
}

std::string text_of(const ObjectRun& run) {
  return "the curve passes the object from " + coordinates(run.from) + " to " + coordinates(run.to);
}

tl::unexpected<Error> letter_missing(const CrossingList& list, const Stop& stop, std::size_t k) {
  const std::string number = std::to_string(k + 1);
  const bool is_end = k == list.letters.size();
  const std::string found =
      is_end ? ", and 'crossings' ends before"
             : ", but letter " + number + " of 'crossings' is " + list.letters.substr(k, 1);
  if (stop.run != nullptr)
    return failure(list.place, text_of(*stop.run) + " of the drawing" + found,
                   "write F as letter " + number + " if it lies in front, B if behind");
  return failure(list.place,
                 "passage " + number + " is the crossing at " + coordinates(stop.point) +
                     " of the drawing" + found,
                 is_end ? "write O if it passes over, U if under"
                        : "draw the curve over the object before that, or remove the letter");
}

tl::unexpected<Error> too_many_letters(const CrossingList& list, std::size_t stops) {
  const std::string first = list.letters.substr(stops, 1);
  return failure(list.place,
                 "letter " + std::to_string(stops + 1) + " of 'crossings' is " + first +
                     ", but the drawing has " + std::to_string(stops) +
                     (stops == 1 ? " passage" : " passages") + " of crossings and the object",
                 is_of_object(first.front())
                     ? "draw the curve over the object, or remove the letter"
                     : "remove the letter");
}

Result<std::vector<ObjectPassage>> as_listed(const std::vector<DoublePoint>& points,
                                             const std::vector<ObjectRun>& runs,
                                             const CrossingList& list) {
  const std::vector<Stop> stops = stops_along(points, runs);
  std::vector<ObjectPassage> passages;
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const bool is_run = stops[k].run != nullptr;
    if (k >= list.letters.size() || is_of_object(list.letters[k]) != is_run)
      return letter_missing(list, stops[k], k);
    if (is_run) passages.push_back({*stops[k].run, list.letters[k] == 'F'});
  }
  if (list.letters.size() > stops.size()) return too_many_letters(list, stops.size());
  return passages;
}

// How much of a run lies within a piece of the drawing.
double common(const ObjectRun& run, const DepthPart& part) {
  return std::max(0.0, std::min(run.end, static_cast<double>(part.end)) -
                           std::max(run.begin, static_cast<double>(part.begin)));
}

Result<void> each_part_passes(const std::vector<ObjectRun>& runs, const JoinedDrawing& drawing) {
  for (const DepthPart& part : drawing.depths) {
    if (std::any_of(runs.begin(), runs.end(),
                    [&](const ObjectRun& run) { return common(run, part) > 0; }))
      continue;
    const bool in_front = part.depth == Depth::front;
    return failure(drawing_place(drawing.points[(part.begin + part.end) / 2]),
                   std::string("this part is drawn ") + (in_front ? "in front of" : "behind") +
                       " the object, but does not pass it",
                   "draw it as the rest, or correct curve.origin, curve.unit or the obstacle");
  }
  return {};
}

// A run lies behind the object where most of it is drawn so.
Result<std::vector<ObjectPassage>> as_drawn(const std::vector<ObjectRun>& runs,
                                            const JoinedDrawing& drawing) {
  if (auto passes = each_part_passes(runs, drawing); !passes) return tl::unexpected(passes.error());
  std::vector<ObjectPassage> passages;
  for (const ObjectRun& run : runs) {
    double behind = 0;
    for (const DepthPart& part : drawing.depths)
      if (part.depth == Depth::behind) behind += common(run, part);
    passages.push_back({run, behind < 0.5 * (run.end - run.begin)});
  }
  return passages;
}

Result<void> ends_lead_out(const Drawing& drawing, const std::vector<ObjectRun>& runs) {
  for (const ObjectRun& run : runs) {
    const bool is_start = run.begin == 0;
    if (!is_start && run.end < static_cast<double>(drawing.size() - 1)) continue;
    return failure(drawing_place(is_start ? drawing.front() : drawing.back()),
                   "an end of the curve lies in front of the object or behind it",
                   "lead it out past the object's outline");
  }
  return {};
}

}  // namespace

std::vector<ObjectRun> find_object_runs(const Drawing& drawing, const ObjectHeights& object) {
  const double longest = sample_per_extent * extent_of(drawing);
  std::vector<ObjectRun> runs;
  bool passes = false;
  const auto look = [&](const Vector2d& point, double parameter) {
    const auto heights = object(point);
    if (heights && !passes) runs.push_back({parameter, parameter, point, point, *heights});
    passes = heights.has_value();
    if (!passes) return;
    runs.back().end = parameter;
    runs.back().to = point;
    runs.back().object.include(*heights);
  };
  look(drawing.front(), 0);
  for (std::size_t i = 0; i + 1 < drawing.size(); ++i) {
    const Vector2d way = drawing[i + 1] - drawing[i];
    const auto pieces = static_cast<int>(std::ceil(length_of(way) / longest));
    for (int k = 1; k <= pieces; ++k) {
      const double fraction = static_cast<double>(k) / pieces;
      look(drawing[i] + fraction * way, static_cast<double>(i) + fraction);
    }
  }
  return runs;
}

bool tells_of_object(const JoinedDrawing& drawing, const CurveScene& scene) {
  return !drawing.depths.empty() ||
         (scene.crossings && std::any_of(scene.crossings->letters.begin(),
                                         scene.crossings->letters.end(), is_of_object));
}

Result<std::vector<ObjectPassage>> object_passages(const std::vector<DoublePoint>& points,
                                                   const JoinedDrawing& drawing,
                                                   const CurveScene& scene,
                                                   const ObjectHeights& object) {
  if (!tells_of_object(drawing, scene)) return std::vector<ObjectPassage>();
  std::optional<std::vector<ObjectRun>> runs;
  if (object) runs = find_object_runs(drawing.points, object);
  return object_passages(points, drawing, scene, runs);
}

Result<std::vector<ObjectPassage>> object_passages(
    const std::vector<DoublePoint>& points, const JoinedDrawing& drawing, const CurveScene& scene,
    const std::optional<std::vector<ObjectRun>>& runs) {
  if (!tells_of_object(drawing, scene)) return std::vector<ObjectPassage>();
  const std::string place = scene.crossings ? scene.crossings->place : "drawing";
  if (!runs)
    return failure(place, "tells what lies in front of the object and behind it, but there is none",
                   "add [obstacle] to the scene");
  if (auto out = ends_lead_out(drawing.points, *runs); !out) return tl::unexpected(out.error());
  return scene.crossings ? as_listed(points, *runs, *scene.crossings) : as_drawn(*runs, drawing);
}

std::vector<CountedPassage> counted(const std::vector<Passage>& passages,
                                    const std::vector<ObjectPassage>& objects) {
  std::vector<CountedPassage> all;
  for (std::size_t i = 0; i < passages.size(); ++i)
    all.push_back({passages[i].parameter, i, false});
  for (std::size_t i = 0; i < objects.size(); ++i) all.push_back({objects[i].run.begin, i, true});
  std::stable_sort(all.begin(), all.end(), [](const CountedPassage& a, const CountedPassage& b) {
    return a.parameter < b.parameter;
  });
  return all;
}

std::string letters_of(const std::vector<Crossing>& crossings,
                       const std::vector<ObjectPassage>& objects) {
  const auto passages = passages_along(crossings);
  std::string letters;
  for (const CountedPassage& passage : counted(passages, objects))
    letters += passage.of_object ? (objects[passage.index].in_front ? 'F' : 'B')
                                 : (passages[passage.index].over ? 'O' : 'U');
  return letters;
}

}  // namespace ribbon

#include "recorder/page/drawn_diagram.h"

#include "curve/axis_view.h"
#include "curve/crossings.h"
#include "curve/joined_drawing.h"
#include "curve/object_heights.h"
#include "curve/object_passages.h"
#include "curve/over_under.h"
#include "curve/place.h"
#include "recorder/run/drawn_knot.h"
#include "text/json.h"

namespace ribbon {

namespace {

Json json_of(const std::vector<Crossing>& crossings) {
  Json list = Json::list({});
  for (const Crossing& crossing : crossings)
    list.add({{"at", Json::list({crossing.point.x(), crossing.point.y()})},
              {"first", crossing.first},
              {"second", crossing.second},
              {"first_over", crossing.first_over}});
  return list;
}

std::vector<Crossing> all_first_over(const std::vector<DoublePoint>& points) {
  std::vector<Crossing> crossings;
  crossings.reserve(points.size());
  for (const DoublePoint& point : points)
    crossings.push_back(
        {point.first, point.second, point.point, true, point.sign_if_first_is_over});
  return crossings;
}

Json json_of(const std::vector<ObjectPassage>& passages) {
  Json list = Json::list({});
  for (const auto& [run, in_front] : passages)
    list.add({{"at", Json::list({run.from.x(), run.from.y()})},
              {"begin", run.begin},
              {"end", run.end},
              {"in_front", in_front}});
  return list;
}

std::vector<ObjectPassage> all_in_front(const std::vector<ObjectRun>& runs) {
  std::vector<ObjectPassage> passages;
  passages.reserve(runs.size());
  for (const ObjectRun& run : runs) passages.push_back({run, true});
  return passages;
}

// A curve of which nobody says whether it passes the object in front of it or behind it runs into
// it.
Result<std::vector<ObjectPassage>> told_passages(
    const std::vector<DoublePoint>& points, const JoinedDrawing& drawing, const CurveScene& curve,
    const std::optional<std::vector<ObjectRun>>& runs) {
  if (!runs || runs->empty() || tells_of_object(drawing, curve))
    return object_passages(points, drawing, curve, runs);
  return failure(drawing_place((runs->front().from + runs->front().to) / 2),
                 "the curve leads through the object",
                 "lead it round the object's outline, or say whether it passes in front or behind");
}

}  // namespace

Result<std::string> diagram_json(const Scene& scene, const std::optional<TriangleMesh>& obstacle) {
  const auto drawing = read_drawing(scene.curve);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto points = find_double_points(drawing->points);
  if (!points) return tl::unexpected(points.error());
  const auto told = over_and_under(*points, *drawing, scene.curve);
  const std::vector<Crossing> crossings = told ? *told : all_first_over(*points);
  std::optional<std::vector<ObjectRun>> runs;
  if (obstacle) runs = find_object_runs(drawing->points, heights_of(obstacle, scene.curve));
  const auto passes = told_passages(*points, *drawing, scene.curve, runs);
  const std::string problem =
      !told ? told.error().sentence() : (passes ? "" : passes.error().sentence());
  return Json{
      {"crossings", json_of(crossings)},
      {"passes", json_of(passes ? *passes : all_in_front(runs.value_or(std::vector<ObjectRun>())))},
      {"letters", letters_of(crossings, passes.value_or(std::vector<ObjectPassage>()))},
      {"knot", told ? text_of_knot(diagram_of(crossings)) : ""},
      {"problem", problem}}
      .line();
}

std::vector<float> silhouette(const TriangleMesh& obstacle, const CurveScene& curve) {
  std::vector<float> corners;
  corners.reserve(2 * static_cast<std::size_t>(obstacle.triangles.size()));
  for (const int corner : obstacle.triangles.reshaped()) {
    const Eigen::Vector3d seen =
        as_seen(obstacle.vertices.col(corner).cast<double>(), curve.axis) / curve.unit_m;
    corners.push_back(static_cast<float>(seen.x() + curve.origin.x()));
    corners.push_back(static_cast<float>(seen.y() + curve.origin.y()));
  }
  return corners;
}

}  // namespace ribbon

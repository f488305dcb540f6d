#include "recorder/page/scene_json.h"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "curve/crossings.h"
#include "curve/joined_drawing.h"
#include "curve/object_heights.h"
#include "curve/object_passages.h"
#include "curve/outline.h"
#include "curve/over_under.h"
#include "obstacle/obstacle.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// In as few decimal digits as tell it.
double told_shortly(float number) {
  constexpr int enough_digits = 9;
  double told = number;
  for (int digits = enough_digits; digits > 0; --digits) {
    const double shorter = std::strtod(short_number(number, digits).c_str(), nullptr);
    if (static_cast<float>(shorter) != number) break;
    told = shorter;
  }
  return told;
}

std::vector<double> numbers_of(const Eigen::Matrix3Xf& vertices) {
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(vertices.size()));
  for (const float coordinate : vertices.reshaped()) numbers.push_back(told_shortly(coordinate));
  return numbers;
}

// As fine as anybody could draw it: to a ten-thousandth of its extent.
std::vector<double> rounded(const Drawing& drawing) {
  const double grain = std::exp2(std::floor(std::log2(extent_of(drawing) * 1e-4)));
  std::vector<double> numbers;
  numbers.reserve(2 * drawing.size());
  for (const Eigen::Vector2d& point : drawing)
    for (const double coordinate : point) numbers.push_back(std::round(coordinate / grain) * grain);
  return numbers;
}

// Over and under of each crossing, in front of the object or behind it of each passage.
std::string list_for(const JoinedDrawing& drawing, const CurveScene& curve,
                     const std::optional<TriangleMesh>& obstacle) {
  const auto points = find_double_points(drawing.points);
  if (!points) return "";
  const auto crossings = over_and_under(*points, drawing, curve);
  if (!crossings) return "";
  std::optional<std::vector<ObjectRun>> runs;
  if (obstacle) runs = find_object_runs(drawing.points, heights_of(obstacle, curve));
  const auto passages = object_passages(*points, drawing, curve, runs);
  return passages ? letters_of(*crossings, *passages) : "";
}

Json json_of(const ObstacleScene& scene, const TriangleMesh& mesh) {
  return {{"file", scene.file.path.filename().string()},
          {"name", mesh.name},
          {"vertices", numbers_of(mesh.vertices)},
          {"triangles",
           std::vector<int>(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size())}};
}

}  // namespace

Result<Json> scene_json(const Scene& wanted) {
  const auto read = with_outline_read(wanted);
  if (!read) return tl::unexpected(read.error());
  const Scene& scene = *read;
  const auto drawing = read_drawing(scene.curve);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto obstacle = read_obstacle(scene);
  if (!obstacle) return tl::unexpected(obstacle.error());
  Json json{{"file", scene.file.filename().string()},
            {"text", scene.text},
            {"name", scene.name},
            {"points", rounded(drawing->points)},
            {"letters", list_for(*drawing, scene.curve, *obstacle)},
            {"unit_m", scene.curve.unit_m},
            {"origin", Json::list({scene.curve.origin.x(), scene.curve.origin.y()})},
            {"width_m", scene.ribbon.profile ? 0.0 : scene.ribbon.width_m},
            {"along", scene.ribbon.along},
            {"across", scene.ribbon.across}};
  if (*obstacle) json.set("object", json_of(*scene.obstacle, **obstacle));
  return json;
}

}  // namespace ribbon

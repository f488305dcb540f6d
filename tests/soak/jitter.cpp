#include "soak/jitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>

#include "curve/joined_drawing.h"
#include "curve/outline.h"
#include "ribbon_mesh/marks.h"
#include "scene/scene.h"

namespace ribbon {

namespace {

// Far enough apart that what each point is moved by bends the curve instead of roughening it.
constexpr double spacing_m = 0.025;

// Points at equal distances along `line`, its two ends among them.
Drawing evenly_spaced(const Drawing& line, double spacing) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  const int pieces = std::max(1, static_cast<int>(std::round(length / spacing)));
  Drawing points = {line.front()};
  double walked = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double piece = (line[i] - line[i - 1]).norm();
    while (static_cast<int>(points.size()) < pieces) {
      const double target = length * static_cast<double>(points.size()) / pieces;
      if (target > walked + piece) break;
      points.emplace_back(line[i - 1] + (target - walked) / piece * (line[i] - line[i - 1]));
    }
    walked += piece;
  }
  points.push_back(line.back());
  return points;
}

// The library's distributions differ from one to the next; its generators do not.
double between_minus_one_and_one(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-52 - 1;
}

std::string points_text(const Drawing& points) {
  std::string text = "points = [\n";
  for (const Eigen::Vector2d& point : points) {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "  [%.6f, %.6f],\n", point[0], point[1]);
    text += line.data();
  }
  return text + "]\n";
}

}  // namespace

Result<std::string> jittered_scene(const std::filesystem::path& file, std::uint64_t seed,
                                   double size_m) {
  const auto scene = read_scene(file).and_then(with_outline_read).and_then([](const Scene& drawn) {
    return with_marks_found(drawn);
  });
  if (!scene) return tl::unexpected(scene.error());
  const auto* svg = std::get_if<DrawnSvg>(&scene->curve.drawing);
  if (svg == nullptr)
    return failure(file.string(), "the curve is not drawn in an SVG file",
                   "jitter a scene that has curve.svg");
  const double unit_m = scene->curve.unit_m;
  const auto drawing = read_drawing(scene->curve);
  if (!drawing) return tl::unexpected(drawing.error());
  if (!drawing->gaps.empty())
    return failure(file.string(), "the curve is drawn with gaps", "jitter a scene that has none");

  Drawing points = evenly_spaced(drawing->points, spacing_m / unit_m);
  std::mt19937_64 random(seed);
  for (Eigen::Vector2d& point : points)
    for (double& coordinate : point)
      coordinate += size_m / unit_m * between_minus_one_and_one(random);

  std::istringstream lines(scene->text);
  std::string text;
  bool above_tables = true;  // stages have names, too
  for (std::string line; std::getline(lines, line);) {
    above_tables = above_tables && !line.starts_with('[');
    if (line.starts_with("svg ="))
      text += points_text(points);
    else if (above_tables && line.starts_with("name ="))
      text += "name = \"" + scene->name + "-jitter-" + std::to_string(seed) + "\"\n";
    else if (!line.starts_with("path ="))
      text += line + "\n";
  }
  return text;
}

}  // namespace ribbon

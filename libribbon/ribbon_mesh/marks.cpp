#include "ribbon_mesh/marks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "curve/axis_view.h"
#include "curve/drawing.h"
#include "geometry/vectors.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/document.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;

constexpr double about_as_near = 0.25;  // widths
constexpr double another_part = 2;      // widths along the band

// A hand that is asked for at a mark.
struct MarkedHand {
  std::string path;  // "stage[1].hand[2]"
  std::string id;
};

std::vector<MarkedHand> marked_hands(const Scene& scene) {
  std::vector<MarkedHand> hands;
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    for (std::size_t j = 0; j < scene.stages[i].hands.size(); ++j)
      if (const auto* mark = std::get_if<Mark>(&scene.stages[i].hands[j].at))
        hands.push_back(
            {"stage[" + std::to_string(i + 1) + "].hand[" + std::to_string(j + 1) + "]", mark->id});
  return hands;
}

std::string list_of(const std::vector<DrawnMark>& marks) {
  std::string list;
  for (const DrawnMark& mark : marks) list += (list.empty() ? "" : ", ") + in_quotes(mark.id);
  return list.empty() ? "draw a circle with that id" : "it has " + list;
}

// Distances in the drawing from the middle of each row to the mark.
std::vector<double> distances_m(const CurveScene& curve, const RibbonMesh& ribbon,
                                const Vector2d& mark) {
  const Vector2d mark_m = (mark - curve.origin) * curve.unit_m;
  std::vector<double> distances;
  for (const auto& point : ribbon.curve.colwise())
    distances.push_back(length_of((as_seen(point, curve.axis).head<2>() - mark_m).eval()));
  return distances;
}

Result<Span> span_at(const CurveScene& curve, const RibbonMesh& ribbon, const DrawnMark& mark) {
  const std::vector<double> distances = distances_m(curve, ribbon, mark.middle);
  const auto nearest = std::ranges::min_element(distances);
  const double row_m = ribbon.length_m / (ribbon.grid.along - 1);
  const auto row = static_cast<double>(nearest - distances.begin());
  for (std::size_t other = 0; other < distances.size(); ++other)
    if (std::abs(static_cast<double>(other) - row) * row_m > another_part * ribbon.width_m &&
        distances[other] < *nearest + about_as_near * ribbon.width_m)
      return failure("",
                     "two parts of the band pass about as near to the mark " + in_quotes(mark.id),
                     "move the circle to where only one of them is");
  const double middle = row / (ribbon.grid.along - 1);
  const double half = 0.5 * ribbon.width_m / ribbon.length_m;
  return Span{std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

Result<std::vector<DrawnMark>> marks_of(const CurveScene& curve) {
  const auto* svg = std::get_if<DrawnSvg>(&curve.drawing);
  if (svg == nullptr)
    return failure("", "marks are circles of an SVG file, but the drawing is a list of points",
                   "write two shares of the band's length, for example 'at = [0, 0.02]'");
  if (auto there = check_readable(svg->file); !there) return tl::unexpected(there.error());
  return find_svg_marks(svg->file.path);
}

Result<Span> span_of(const std::string& id, const Scene& scene, const RibbonMesh& ribbon) {
  const auto marks = marks_of(scene.curve);
  if (!marks) return tl::unexpected(marks.error());
  const auto mark =
      std::ranges::find_if(*marks, [&](const DrawnMark& one) { return one.id == id; });
  if (mark == marks->end())
    return failure("", "the drawing has no mark " + in_quotes(id), list_of(*marks));
  return span_at(scene.curve, ribbon, *mark);
}

}  // namespace

Result<Scene> with_marks_found(const Scene& scene, const std::optional<TriangleMesh>& obstacle) {
  const std::vector<MarkedHand> hands = marked_hands(scene);
  if (hands.empty()) return scene;
  const auto document = parse_document(scene.file, scene.text);
  if (!document) return tl::unexpected(document.error());
  const auto ribbon = draw_ribbon(scene, obstacle);
  if (!ribbon) return tl::unexpected(ribbon.error());
  std::vector<std::string> settings;
  for (const MarkedHand& hand : hands) {
    auto span = span_of(hand.id, scene, *ribbon);
    if (!span && span.error().place.empty()) span.error().place = document->place(hand.path, "at");
    if (!span) return tl::unexpected(span.error());
    settings.push_back(hand.path + ".at=[" + shortest(span->begin) + ", " + shortest(span->end) +
                       "]");
  }
  auto found = read_scene(scene.file, scene.text, settings);
  if (found) found->name = scene.name;
  return found;
}

}  // namespace ribbon

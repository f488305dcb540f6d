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
#include "ribbon_mesh/carry_way.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/document.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;

constexpr double about_as_near = 0.25;  // widths
constexpr double another_part = 2;      // widths along the band

// A hand that is told by the drawing: at a mark, or on a path.
struct DrawnHand {
  std::string table;                // "stage[1].hand[2]"
  const Mark* at = nullptr;         // null: it is told otherwise
  const PathId* carries = nullptr;  // likewise
};

bool is_at_mark(const HandScene& hand) {
  return std::holds_alternative<Mark>(hand.at);
}

bool is_carried_as_drawn(const HandScene& hand) {
  return hand.task == HandTask::carry && std::holds_alternative<PathId>(hand.carry.path);
}

std::vector<DrawnHand> drawn_hands(const Scene& scene) {
  std::vector<DrawnHand> hands;
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    for (std::size_t j = 0; j < scene.stages[i].hands.size(); ++j) {
      const HandScene& hand = scene.stages[i].hands[j];
      if (is_at_mark(hand) || is_carried_as_drawn(hand))
        hands.push_back(
            {"stage[" + std::to_string(i + 1) + "].hand[" + std::to_string(j + 1) + "]",
             std::get_if<Mark>(&hand.at),
             is_carried_as_drawn(hand) ? std::get_if<PathId>(&hand.carry.path) : nullptr});
    }
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

// Of the nearest row; fails without a place, or with that of the mark in its drawing.
Result<double> share_at(const CurveScene& curve, const RibbonMesh& ribbon, const DrawnMark& mark) {
  if (!mark.middle) return tl::unexpected(mark.middle.error());
  const std::vector<double> distances = distances_m(curve, ribbon, *mark.middle);
  const auto nearest = std::min_element(distances.begin(), distances.end());
  const double row_m = ribbon.length_m / (ribbon.grid.along - 1);
  const auto row = static_cast<double>(nearest - distances.begin());
  for (std::size_t other = 0; other < distances.size(); ++other)
    if (std::abs(static_cast<double>(other) - row) * row_m > another_part * ribbon.width_m &&
        distances[other] < *nearest + about_as_near * ribbon.width_m)
      return failure("",
                     "two parts of the band pass about as near to the mark " + in_quotes(mark.id),
                     "move the circle to where only one of them is");
  return row / (ribbon.grid.along - 1);
}

Result<std::vector<DrawnMark>> marks_of(const CurveScene& curve) {
  const auto* svg = std::get_if<DrawnSvg>(&curve.drawing);
  if (svg == nullptr)
    return failure("", "marks are circles of an SVG file, but the drawing is a list of points",
                   "write shares of the band's length, for example [0, 0.02]");
  if (auto there = check_readable(svg->file); !there) return tl::unexpected(there.error());
  return find_svg_marks(svg->file.path);
}

// What has no place of its own is wrong with what the scene names there.
template <class Value>
Result<Value> named_at(const std::string& place, Result<Value> found) {
  if (!found && found.error().place.empty()) found.error().place = place;
  return found;
}

Result<double> share_of(const std::string& id, const Scene& scene, const RibbonMesh& ribbon) {
  const auto marks = marks_of(scene.curve);
  if (!marks) return tl::unexpected(marks.error());
  const auto mark = std::find_if(marks->begin(), marks->end(),
                                 [&](const DrawnMark& one) { return one.id == id; });
  if (mark == marks->end())
    return failure("", "the drawing has no mark " + in_quotes(id), list_of(*marks));
  return share_at(scene.curve, ribbon, *mark);
}

Result<double> share_of(const Mark& mark, const Scene& scene, const RibbonMesh& ribbon) {
  return named_at(mark.place, share_of(mark.id, scene, ribbon));
}

// As long as the band is wide.
std::string span_text(double middle, const RibbonMesh& ribbon) {
  const double half = 0.5 * ribbon.width_m / ribbon.length_m;
  return "[" + shortest(std::max(0.0, middle - half)) + ", " +
         shortest(std::min(1.0, middle + half)) + "]";
}

Result<std::string> span_setting(const DrawnHand& hand, const Scene& scene,
                                 const RibbonMesh& ribbon) {
  return share_of(*hand.at, scene, ribbon).map([&](double share) {
    return hand.table + ".at=" + span_text(share, ribbon);
  });
}

Result<std::string> carry_setting(const DrawnHand& hand, const CurveScene& curve) {
  const auto path = named_at(hand.carries->place, drawn_path(curve, *hand.carries));
  return path.map([&](const std::vector<Vector2d>& path_points) {
    std::string points;
    for (const Vector2d& point : path_points)
      points +=
          (points.empty() ? "[" : ", [") + shortest(point.x()) + ", " + shortest(point.y()) + "]";
    return hand.table + ".carry=[" + points + "]";
  });
}

bool is_marked(const Scene& scene) {
  if (!scene.knot || !scene.knot->between) return false;
  const auto& ends = scene.knot->between->ends;
  return std::any_of(ends.begin(), ends.end(),
                     [](const auto& end) { return std::holds_alternative<Mark>(end); });
}

Result<std::string> between_setting(const Scene& scene, const RibbonMesh& ribbon) {
  std::string setting;
  for (const auto& end : scene.knot->between->ends) {
    const auto* mark = std::get_if<Mark>(&end);
    const auto share =
        mark != nullptr ? share_of(*mark, scene, ribbon) : Result<double>(std::get<double>(end));
    if (!share) return tl::unexpected(share.error());
    setting += (setting.empty() ? "knot.between=[" : ", ") + shortest(*share);
  }
  return setting + "]";
}

// Those that replace marks and paths.
Result<std::vector<std::string>> settings_for_marks(const Scene& scene, const RibbonMesh& ribbon) {
  std::vector<std::string> settings;
  const auto add = [&](Result<std::string> setting) {
    return setting.map([&](std::string& text) { settings.push_back(std::move(text)); });
  };
  for (const DrawnHand& hand : drawn_hands(scene)) {
    Result<void> added;
    if (hand.at != nullptr) added = add(span_setting(hand, scene, ribbon));
    if (added && hand.carries != nullptr) added = add(carry_setting(hand, scene.curve));
    if (!added) return tl::unexpected(added.error());
  }
  if (is_marked(scene))
    if (auto added = add(between_setting(scene, ribbon)); !added)
      return tl::unexpected(added.error());
  return settings;
}

// All else may have been changed since the scene was read.
Scene with_shares_of(const Scene& read, Scene scene) {
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    for (std::size_t j = 0; j < scene.stages[i].hands.size(); ++j) {
      HandScene& hand = scene.stages[i].hands[j];
      if (is_at_mark(hand)) hand.at = read.stages[i].hands[j].at;
      if (is_carried_as_drawn(hand)) hand.carry.path = read.stages[i].hands[j].carry.path;
    }
  if (is_marked(scene)) scene.knot->between = read.knot->between;
  scene.text = read.text;
  return scene;
}

}  // namespace

bool names_marks(const Scene& scene) {
  return !drawn_hands(scene).empty() || is_marked(scene);
}

Result<Scene> with_marks_found(const Scene& scene, const std::optional<TriangleMesh>& obstacle) {
  if (!names_marks(scene)) return scene;
  const auto ribbon = draw_ribbon(scene, obstacle);
  if (!ribbon) return tl::unexpected(ribbon.error());
  const auto settings = settings_for_marks(scene, *ribbon);
  if (!settings) return tl::unexpected(settings.error());
  const auto found = read_scene(scene.file, scene.text, *settings);
  return found.map([&scene](const Scene& read) { return with_shares_of(read, scene); });
}

std::vector<PlacedMark> marks_on(const CurveScene& curve, const RibbonMesh& ribbon) {
  std::vector<PlacedMark> placed;
  const auto marks = marks_of(curve);
  for (const DrawnMark& mark : marks ? *marks : std::vector<DrawnMark>())
    if (const auto share = share_at(curve, ribbon, mark)) placed.push_back({mark.id, *share});
  return placed;
}

}  // namespace ribbon

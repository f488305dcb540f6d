#include "recorder/show_crossings.h"

#include <algorithm>
#include <system_error>

#include "curve/crossings.h"
#include "curve/diagram_svg.h"
#include "curve/joined_drawing.h"
#include "curve/over_under.h"
#include "files/files.h"
#include "knot/type/tied_forms.h"
#include "recorder/run/drawn_knot.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// As if all were over: without gaps.
std::vector<Passage> numbered(const std::vector<DoublePoint>& points) {
  std::vector<Crossing> crossings;
  crossings.reserve(points.size());
  for (const DoublePoint& point : points)
    crossings.push_back({point.first, point.second, point.point});
  std::vector<Passage> passages = passages_along(crossings);
  for (Passage& passage : passages) passage.over = true;
  return passages;
}

std::string text_of(const std::vector<Crossing>& crossings) {
  if (crossings.empty()) return "the drawing does not cross itself\n";
  const KnotDiagram diagram = diagram_of(crossings);
  return filled_in("crossings = \"{}\"\nGauss code: {}\nknot: {}\n", letters_of(crossings),
                   gauss_code(diagram), text_of_knot(diagram));
}

}  // namespace

Result<std::string> show_crossings(const Scene& scene, const std::filesystem::path& file,
                                   Overwrite overwrite) {
  std::error_code code;
  if (overwrite == Overwrite::no && std::filesystem::exists(file, code))
    return failure(file.string(), "exists already", "name another file, or replace it by --force");
  const auto drawing = read_drawing(scene.curve);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto points = find_double_points(drawing->points);
  if (!points) return tl::unexpected(points.error());
  const auto crossings = over_and_under(*points, *drawing, scene.curve);
  const auto passages = crossings ? passages_along(*crossings) : numbered(*points);
  if (auto written = write_file(file, diagram_svg(drawing->points, passages)); !written)
    return tl::unexpected(written.error());
  return crossings.map(text_of);
}

}  // namespace ribbon

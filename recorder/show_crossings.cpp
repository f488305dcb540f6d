#include "recorder/show_crossings.h"

#include <optional>
#include <vector>

#include "curve/crossings.h"
#include "curve/diagram_svg.h"
#include "curve/joined_drawing.h"
#include "curve/object_heights.h"
#include "curve/object_passages.h"
#include "curve/over_under.h"
#include "files/files.h"
#include "knot/type/tied_forms.h"
#include "obstacle/obstacle.h"
#include "recorder/run/drawn_knot.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// What can be drawn of a drawing whose over and under, or front and back, cannot be told: its
// passages as if all were over and in front, without gaps.
struct NumberedPassages {
  std::vector<Passage> crossings;
  std::vector<ObjectPassage> objects;
};

NumberedPassages numbered(const std::vector<DoublePoint>& points,
                          const std::vector<ObjectRun>& runs) {
  std::vector<Crossing> crossings;
  crossings.reserve(points.size());
  for (const DoublePoint& point : points)
    crossings.push_back({point.first, point.second, point.point});
  NumberedPassages all{passages_along(crossings), {}};
  for (Passage& passage : all.crossings) passage.over = true;
  for (const ObjectRun& run : runs) all.objects.push_back({run});
  return all;
}

std::string text_of(const std::vector<Crossing>& crossings,
                    const std::vector<ObjectPassage>& objects) {
  if (crossings.empty() && objects.empty()) return "the drawing does not cross itself\n";
  const KnotDiagram diagram = diagram_of(crossings);
  return filled_in("crossings = \"{}\"\nGauss code: {}\nknot: {}\n", letters_of(crossings, objects),
                   gauss_code(diagram), text_of_knot(diagram));
}

// Of a list that does not tell of the object.
std::string text_of(const std::vector<ObjectRun>& runs) {
  return filled_in(
      "the curve passes the object {}; where it lies in front of it or behind, F or B in "
      "'crossings' tells it\n",
      runs.size() == 1 ? "once" : filled_in("{} times", runs.size()));
}

// The numbers are in the file for who mends it.
tl::unexpected<Error> with_numbers(Error why, const std::filesystem::path& file) {
  why.remedy += filled_in(" ('{}' shows the passages with their numbers)", file.string());
  return tl::unexpected(std::move(why));
}

}  // namespace

Result<std::string> show_crossings(const Scene& scene, const std::filesystem::path& file,
                                   Older older) {
  if (older == Older::stays && is_taken(file))
    return failure(file.string(), "exists already", "name another file, or replace it by --force");
  const auto drawing = read_drawing(scene.curve);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto points = find_double_points(drawing->points);
  if (!points) return tl::unexpected(points.error());
  const auto obstacle = read_obstacle(scene);
  if (!obstacle) return tl::unexpected(obstacle.error());
  const ObjectHeights heights = heights_of(*obstacle, scene.curve);
  std::optional<std::vector<ObjectRun>> runs;
  if (heights) runs = find_object_runs(drawing->points, heights);
  const auto objects = object_passages(*points, *drawing, scene.curve, runs);
  const auto crossings = over_and_under(*points, *drawing, scene.curve);
  const NumberedPassages drawn = crossings && objects
                                     ? NumberedPassages{passages_along(*crossings), *objects}
                                     : numbered(*points, runs.value_or(std::vector<ObjectRun>()));
  if (auto written =
          write_file(file, diagram_svg(drawing->points, drawn.crossings, drawn.objects), older);
      !written)
    return tl::unexpected(written.error());
  if (!objects) return with_numbers(objects.error(), file);
  if (!crossings) return with_numbers(crossings.error(), file);
  return text_of(*crossings, *objects) +
         (runs && runs->size() > objects->size() ? text_of(*runs) : std::string());
}

}  // namespace ribbon

#include "curve/diagram_svg.h"

#include <gtest/gtest.h>

#include <cmath>

#include "curve/joined_drawing.h"
#include "curve/trefoil_drawing.h"
#include "files/files.h"
#include "files/temporary_folder.h"
#include "result/refusal.h"

namespace ribbon::diagram_svg_test {

std::string diagram_of(const std::string& letters) {
  const auto crossings = as_listed(find_double_points(trefoil_drawing).value(), {letters}).value();
  return diagram_svg(trefoil_drawing, passages_along(crossings), {});
}

TEST(DiagramSvg, gaps_read_back_are_the_passages_under) {
  for (const char* letters : {"OUOUOU", "UOUOUO", "OOOUUU", "OOUUUO"}) {
    const auto file = temporary_file("diagram.svg");
    ASSERT_TRUE(write_file(file, diagram_of(letters)).has_value());
    CurveScene scene;
    scene.drawing = DrawnSvg{{file}, "band"};
    const auto drawing = read_drawing(scene);
    ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
    EXPECT_EQ(drawing->gaps.size(), 3U);
    const auto crossings =
        over_and_under(find_double_points(drawing->points).value(), *drawing, scene);
    ASSERT_TRUE(crossings.has_value()) << crossings.error().sentence();
    EXPECT_EQ(letters_of(*crossings, {}), letters);
  }
}

TEST(DiagramSvg, strokes_before_and_behind_the_object_are_read_back) {
  const ObjectHeights bar = [](const Eigen::Vector2d& place) -> std::optional<HeightRange> {
    if (std::abs(place.x() - 2) > 0.2) return std::nullopt;
    return HeightRange{-1, 1};
  };
  CurveScene scene;
  scene.drawing = DrawnPoints{trefoil_drawing};
  scene.crossings = CrossingList{"OFUOBUBOU"};
  const auto points = find_double_points(trefoil_drawing).value();
  const JoinedDrawing as_points{trefoil_drawing, {}};
  const auto objects = object_passages(points, as_points, scene, bar);
  ASSERT_TRUE(objects.has_value()) << objects.error().sentence();
  const auto crossings = over_and_under(points, as_points, scene).value();
  const auto file = temporary_file("diagram.svg");
  const std::string svg = diagram_svg(trefoil_drawing, passages_along(crossings), *objects);
  ASSERT_TRUE(write_file(file, svg).has_value());
  CurveScene drawn;
  drawn.drawing = DrawnSvg{{file}, "band"};
  const auto drawing = read_drawing(drawn);
  ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
  const auto points_again = find_double_points(drawing->points).value();
  const auto objects_again = object_passages(points_again, *drawing, drawn, bar).value();
  EXPECT_EQ(letters_of(over_and_under(points_again, *drawing, drawn).value(), objects_again),
            scene.crossings->letters);
}

TEST(DiagramSvg, passages_are_numbered_from_one) {
  const std::string svg = diagram_of("OUOUOU");
  for (int passage = 1; passage <= 6; ++passage)
    EXPECT_THAT(svg, HasSubstr(">" + std::to_string(passage) + "</text>"));
  EXPECT_THAT(svg, Not(HasSubstr(">7</text>")));
}

TEST(DiagramSvg, the_number_of_a_passage_at_the_very_start_can_be_read) {
  const ObjectRun run{0, 0.5, Eigen::Vector2d(0, 0), Eigen::Vector2d(1.5, 2), {-1, 1}};
  const std::string svg = diagram_svg({{0, 0}, {3, 4}}, {}, {{run, true}});
  EXPECT_THAT(svg, HasSubstr(">1</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("font-size=\"0\"")));
}

TEST(DiagramSvg, a_drawing_without_crossings_is_one_piece) {
  const std::string svg = diagram_svg({{0, 0}, {3, 4}}, {}, {});
  EXPECT_THAT(svg, HasSubstr("<path d=\"M 0 0 3 4\"/>"));
  EXPECT_THAT(svg, Not(HasSubstr("<text")));
}

}  // namespace ribbon::diagram_svg_test

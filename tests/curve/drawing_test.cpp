#include "curve/drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "result/refusal.h"

namespace ribbon::drawing_test {

using Eigen::Vector2d;

constexpr double tolerance = 1e-3;

std::filesystem::path file_with(const std::string& text) {
  auto file = temporary_file("knot.svg");
  EXPECT_TRUE(write_file(file, text).has_value());
  return file;
}

std::filesystem::path svg_with(const std::string& body) {
  std::string text = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 7 7'>\n";
  text += body;
  return file_with(text + "\n</svg>\n");
}

Result<Drawing> read_path(const std::filesystem::path& file, const std::string& id) {
  return find_svg_paths(file, id)
      .and_then([](const std::vector<SvgPath>& paths) { return flattened(paths.at(0), tolerance); })
      .map([](const std::vector<Drawing>& pieces) { return pieces.at(0); });
}

Drawing drawing_of(const std::string& body, const std::string& id = "") {
  const auto drawing = read_path(svg_with(body), id);
  EXPECT_TRUE(drawing.has_value()) << drawing.error().sentence();
  return drawing.value_or(Drawing{});
}

std::string path_of(const std::string& data) {
  std::string path = "<path d='";
  path += data;
  return path + "'/>";
}

Drawing data_of(const std::string& data) {
  return drawing_of(path_of(data));
}

void expect_points(const Drawing& drawing, const Drawing& expected) {
  ASSERT_EQ(drawing.size(), expected.size());
  for (std::size_t i = 0; i < drawing.size(); ++i)
    EXPECT_NEAR((drawing[i] - expected[i]).norm(), 0, 1e-9)
        << i << ": " << drawing[i].transpose() << " is not " << expected[i].transpose();
}

double distance_to(const Drawing& drawing, const Vector2d& point) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < drawing.size(); ++i) {
    const Vector2d way = drawing[i + 1] - drawing[i];
    const double t = std::clamp((point - drawing[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    distance = std::min(distance, (drawing[i] + t * way - point).norm());
  }
  return distance;
}

void expect_curve(const std::string& data, const Drawing& through, const Vector2d& end) {
  const Drawing drawing = data_of(data);
  for (const Vector2d& point : through)
    EXPECT_LE(distance_to(drawing, point), tolerance) << data << " misses " << point.transpose();
  EXPECT_NEAR((drawing.back() - end).norm(), 0, 1e-9) << data;
}

std::string problem_of(const std::filesystem::path& file, const std::string& id = "") {
  return refusal_of(read_path(file, id));
}

void expect_problem(const std::string& problem, const std::string& place,
                    const std::string& words) {
  EXPECT_THAT(problem, HasSubstr(place));
  EXPECT_THAT(problem, HasSubstr(words));
}

TEST(PathData, lines_absolute_and_relative_with_repeats) {
  expect_points(
      data_of("m 10 10 20 0 L 40 20 H 50 h -5 V 40 v 5 l 1 1 -2 3"),
      {{10, 10}, {30, 10}, {40, 20}, {50, 20}, {45, 20}, {45, 40}, {45, 45}, {46, 46}, {44, 49}});
  expect_points(data_of("M 1 2 3 4 5 6 L 7 8 9 10"), {{1, 2}, {3, 4}, {5, 6}, {7, 8}, {9, 10}});
}

TEST(PathData, numbers_as_terse_as_programs_write_them) {
  expect_points(data_of("M.5.5-1-1,1e1,2E-1l+1-.5"), {{.5, .5}, {-1, -1}, {10, .2}, {11, -.3}});
}

TEST(PathData, cubics_and_their_shorthand) {
  // At t = 1/2 a cubic is (p0 + 3 p1 + 3 p2 + p3) / 8.
  expect_curve("M 0 0 C 0 4 4 4 4 0 S 8 -4 8 0", {{2, 3}, {4, 0}, {6, -3}}, {8, 0});
  expect_curve("M 1 1 c 0 4 4 4 4 0 s 4 -4 4 0", {{3, 4}, {5, 1}, {7, -2}}, {9, 1});
  expect_curve("M 0 0 c 0 4 4 4 4 0 0 4 4 4 4 0", {{2, 3}, {6, 3}}, {8, 0});
  // Without a cubic before, the first control point is the current point: (0 + 0 + 3 p2 + p3) / 8.
  expect_curve("M 0 0 S 4 4 4 0", {{2, 1.5}}, {4, 0});
}

TEST(PathData, quadratics_and_their_shorthand) {
  // At t = 1/2 a quadratic is (p0 + 2 p1 + p2) / 4.
  expect_curve("M 0 0 Q 2 4 4 0 T 8 0", {{2, 2}, {6, -2}}, {8, 0});
  expect_curve("M 1 1 q 2 4 4 0 t 4 0 4 0", {{3, 3}, {7, -1}, {11, 3}}, {13, 1});
}

TEST(PathData, arcs_with_all_flags) {
  expect_curve("M 0 0 A 5 5 0 0 1 10 0", {{5, -5}}, {10, 0});
  expect_curve("M 0 0 A 5 5 0 0 0 10 0", {{5, 5}}, {10, 0});
  expect_curve("M 0 0 A 5 5 0 1 1 5 5", {{5, -5}, {10, 0}}, {5, 5});
  expect_curve("M 0 0 A 5 5 0 1 0 5 5", {{-5, 5}, {0, 10}}, {5, 5});
  expect_curve("M 0 0 A 5 5 0 0 0 5 5", {{5 - 5 * std::sqrt(.5), 5 * std::sqrt(.5)}}, {5, 5});
  expect_curve("M 1 1 a 5 5 0 0110 0", {{6, -4}}, {11, 1});
}

TEST(PathData, arcs_rotated_scaled_up_and_degenerate) {
  expect_curve("M 0 0 A 10 5 90 0 1 10 0", {{5, -10}}, {10, 0});
  expect_curve("M 0 0 A 1 1 0 0 1 10 0", {{5, -5}}, {10, 0});
  expect_points(data_of("M 0 0 A 0 5 0 0 1 10 0"), {{0, 0}, {10, 0}});
  expect_points(data_of("M 0 0 A 5 5 0 0 1 0 0 L 3 0"), {{0, 0}, {3, 0}});
}

TEST(PathData, circle_stays_within_the_tolerance_without_waste) {
  const Drawing circle = data_of("M -100 0 A 100 100 0 0 1 100 0");
  for (std::size_t i = 0; i + 1 < circle.size(); ++i) {
    EXPECT_NEAR(circle[i].norm(), 100, 1e-9);
    EXPECT_GE((circle[i] + circle[i + 1]).norm() / 2, 100 - tolerance);
  }
  EXPECT_LT(circle.size(), 900U);  // pi / sqrt(8 tolerance / 100) = 352 chords at the least
}

TEST(PathData, tolerance_holds_after_the_transform) {
  const Drawing circle =
      drawing_of("<path transform='scale(1000)' d='M -0.1 0 A 0.1 0.1 0 0 1 0.1 0'/>");
  for (std::size_t i = 0; i + 1 < circle.size(); ++i)
    EXPECT_GE((circle[i] + circle[i + 1]).norm() / 2, 100 - tolerance);
}

TEST(PathData, repeated_points_are_dropped) {
  expect_points(data_of("M 1 1 L 1 1 2 2 2 2 h 0 l 1 1"), {{1, 1}, {2, 2}, {3, 3}});
}

TEST(SvgTransform, each_kind_by_hand) {
  const auto moved = [](const std::string& transform, const Vector2d& expected) {
    const Drawing drawing = drawing_of("<path transform='" + transform + "' d='M 2 1 L 100 100'/>");
    EXPECT_NEAR((drawing.front() - expected).norm(), 0, 1e-9)
        << transform << " gives " << drawing.front().transpose();
  };
  moved("translate(10,20)", {12, 21});
  moved("translate(10)", {12, 1});
  moved("scale(3)", {6, 3});
  moved("scale(3 -4)", {6, -4});
  moved("rotate(90)", {-1, 2});
  moved("rotate(90, 1, 1)", {1, 2});
  moved("skewX(45)", {3, 1});
  moved("skewY(45)", {2, 3});
  moved("matrix(1 2 3 4 5 6)", {10, 14});
  moved("translate(1) scale(2,3)", {5, 3});
}

TEST(SvgTransform, groups_nest_from_the_outside_in) {
  expect_points(drawing_of("<g transform='translate(10,20)'><g><g transform='rotate(90)'>"
                           "<path transform='scale(2)' d='M 1 0 H 2'/></g></g></g>"),
                {{10, 22}, {10, 24}});
}

TEST(SvgTransform, curves_are_mapped_as_a_whole) {
  const Drawing drawing =
      drawing_of("<g transform='matrix(0 2 -1 0 3 4)'><path d='M 0 0 A 5 5 0 0 1 10 0'/></g>");
  EXPECT_LE(distance_to(drawing, {8, 14}), tolerance);  // of (5, -5)
  EXPECT_NEAR((drawing.back() - Vector2d(3, 24)).norm(), 0, 1e-9);
}

TEST(SvgFile, as_inkscape_writes_it) {
  const auto file = file_with(R"svg(<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<!-- Created with Inkscape (http://www.inkscape.org/) -->
<svg
   width="210mm"
   height="297mm"
   viewBox="0 0 210 297"
   id="svg5"
   sodipodi:docname="knot.svg"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
   xmlns="http://www.w3.org/2000/svg">
  <sodipodi:namedview id="namedview7" inkscape:document-units="mm" showgrid="false">
    <inkscape:grid type="xygrid" id="grid1" />
  </sodipodi:namedview>
  <defs id="defs2">
    <inkscape:path-effect effect="spiro" id="path-effect9" />
    <marker id="arrow"><path d="M 0,0 5,-5" id="head" /></marker>
    <clipPath id="clip"><path d="M 0,0 5,-5" /></clipPath>
  </defs>
  <g inkscape:label="Layer 1" inkscape:groupmode="layer" id="layer1"
     transform="translate(-10,-20)">
    <path
       style="fill:none;stroke:#000000;stroke-width:0.26;display:inline"
       d="m 20,40 c 0,4 4,4 4,0
          0,-4 4,-4 4,0"
       id="path846"
       inkscape:original-d="M 0,0 Z"
       sodipodi:nodetypes="csc" />
  </g>
</svg>
)svg");
  const auto drawing = read_path(file, "");
  ASSERT_TRUE(drawing.has_value()) << drawing.error().sentence();
  EXPECT_EQ(drawing->front(), Vector2d(10, 20));
  EXPECT_LE(distance_to(*drawing, {12, 23}), tolerance);
  EXPECT_LE(distance_to(*drawing, {16, 17}), tolerance);
  EXPECT_EQ(drawing->back(), Vector2d(18, 20));
}

TEST(SvgFile, polylines_and_lines_are_paths_too) {
  expect_points(drawing_of("<polyline points='0,0 1,2\n3,4'/>"), {{0, 0}, {1, 2}, {3, 4}});
  expect_points(drawing_of("<line x1='1' y1='2' x2='3'/>"), {{1, 2}, {3, 0}});
}

TEST(SvgFile, what_is_not_drawn_is_ignored) {
  const std::string hidden = "<path d='M 9 9 L 8 8'/>";
  std::string body;
  for (const char* name : {"defs", "clipPath", "marker", "symbol", "pattern", "mask"})
    body += std::string("<") + name + ">" + hidden + "</" + name + ">";
  body += "<g style='display: none'>" + hidden + "</g><g display='none'>" + hidden + "</g>";
  body += "<path style='stroke:red;display:none' d='M 9 9 L 8 8'/>";
  body += "<path style='display:none !important' d='M 9 9 L 8 8'/>";
  body +=
      "<g visibility='hidden'>" + hidden + "</g><g style='visibility:collapse'>" + hidden + "</g>";
  body +=
      "<style type='text/css'><![CDATA[.st0{display:none;} path.st1{visibility:hidden}]]></style>";
  body += "<style>#guides > g path{display:none}</style><g id='guides'><g>" + hidden + "</g></g>";
  body += "<style media='print'>path{display:none}</style>";
  body += "<g class='st1 st0'>" + hidden + "</g><path class='st1' d='M 9 9 L 8 8'/>";
  body += "<rect width='3' height='3'/><circle r='3'/><text>M 1 1</text>";
  expect_points(drawing_of(body + path_of("M 1 1 L 2 2")), {{1, 1}, {2, 2}});
}

TEST(SvgFile, what_is_shown_in_a_hidden_group_is_drawn) {
  expect_points(drawing_of("<g visibility='hidden'>" + path_of("M 9 9 L 8 8") +
                           "<path visibility='visible' d='M 1 1 L 2 2'/></g>"),
                {{1, 1}, {2, 2}});
}

TEST(SvgFile, prefixed_svg_is_svg) {
  const auto file = file_with(
      "<svg:svg xmlns:svg='http://www.w3.org/2000/svg'><svg:g><svg:path d='M 1 1 L 2 2'/>"
      "</svg:g></svg:svg>");
  expect_points(read_path(file, "").value(), {{1, 1}, {2, 2}});
}

TEST(SvgFile, id_chooses_among_several_paths) {
  expect_points(
      drawing_of("<path id='a' d='M 0 0 L 1 1'/><g><path id='b' d='M 2 2 L 3 3'/></g>", "b"),
      {{2, 2}, {3, 3}});
}

TEST(SvgErrors, missing_file_is_named) {
  expect_problem(problem_of("/no/such/knot.svg"), "/no/such/knot.svg", "cannot be opened");
}

TEST(SvgErrors, broken_xml_is_told_with_its_line) {
  expect_problem(problem_of(file_with("<svg>\n<g>\n<path d='M 0 0'\n</svg>")), ".svg:", "not XML");
  expect_problem(problem_of(file_with("<svg>\n<g>\n</svg>")), ".svg:3", "not XML");
  expect_problem(problem_of(file_with("")), ".svg", "not XML");
  expect_problem(problem_of(file_with("just text")), ".svg", "not XML");
}

TEST(SvgErrors, other_xml_is_told) {
  expect_problem(problem_of(file_with("\n<html></html>")), ".svg:2", "not SVG but <html>");
}

TEST(SvgErrors, no_path) {
  expect_problem(problem_of(svg_with("<rect width='1' height='1'/>")), ".svg", "no path");
}

TEST(SvgErrors, several_paths_are_listed) {
  const std::string problem =
      problem_of(svg_with("<path id='left' d='M 0 0 L 1 1'/>\n<path id='right' d='M 2 2 L 3 3'/>"));
  expect_problem(problem, ".svg:3", "2 paths");
  expect_problem(problem, "'left', 'right'", "write for example 'path = \"left\"' in the scene's");
}

TEST(SvgErrors, paths_without_ids_are_to_get_one) {
  expect_problem(problem_of(svg_with(path_of("M 0 0 L 1 1") + path_of("M 2 2 L 3 3"))), ".svg:2",
                 R"(give one an id, for example "band", and write 'path = "band"')");
}

TEST(SvgErrors, unknown_id_names_those_there_are) {
  expect_problem(problem_of(svg_with("<path id='left' d='M 0 0 L 1 1'/>"), "knot"), "'knot'",
                 "'left'");
}

TEST(SvgErrors, id_of_something_else_says_what_it_is) {
  expect_problem(problem_of(svg_with("<rect id='knot'/>"), "knot"), ".svg:2", "<rect>");
}

TEST(SvgErrors, closed_path) {
  expect_problem(problem_of(svg_with("\n<path id='ring' d='M 0 0 L 1 1 2 0 Z'/>")), ".svg:3",
                 "path 'ring' is closed; open it: in Inkscape");
}

TEST(SvgErrors, several_pieces_are_for_who_joins_them) {
  const auto file = svg_with("<g id='band'>" + path_of("M 0 0 L 1 1 M 2 2 L 3 3") +
                             path_of("M 4 4 L 5 5") + "</g>" + path_of("M 9 9 L 8 8"));
  const auto paths = find_svg_paths(file, "band").value();
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(flattened(paths[0], tolerance)->size(), 2U);
  expect_points(flattened(paths[0], tolerance)->at(1), {{2, 2}, {3, 3}});
  expect_points(flattened(paths[1], tolerance)->at(0), {{4, 4}, {5, 5}});
  expect_points(data_of("M 9 9 M 0 0 L 1 1 M 5 5"), {{0, 0}, {1, 1}});
}

TEST(SvgErrors, malformed_data_and_transforms) {
  for (const char* data : {"L 1 1", "M 0 0 L 1", "M 0 0 L nan 1", "M 0 0 X 1 1", "M 0 0 L inf 2"})
    expect_problem(problem_of(svg_with(path_of(data))), ".svg:2", "cannot be read");
  expect_problem(problem_of(svg_with("<g\ntransform='turn(3)'>" + path_of("M 0 0 L 1 1") + "</g>")),
                 ".svg:2", "'turn(3)'");
  expect_problem(problem_of(svg_with("<line x1='1mm' x2='3'/>")), ".svg:2", "cannot be read");
}

TEST(SvgErrors, styles_that_are_not_read_are_told) {
  const std::string path = path_of("M 0 0 L 1 1");
  expect_problem(problem_of(svg_with("<g style='transform:translate(5px)'>" + path + "</g>")),
                 ".svg:2", "write it as an attribute");
  expect_problem(problem_of(svg_with("<style>g{transform:scale(2)}</style><g>" + path + "</g>")),
                 ".svg:2", "write it as an attribute");
  expect_points(drawing_of("<g style='transform:none'>" + path + "</g>"), {{0, 0}, {1, 1}});
  expect_problem(
      problem_of(
          svg_with("\n<style>a + path{display:none}</style>\n<style>.b{fill:none}</style>" + path)),
      ".svg:3", "'a + path'");
  expect_points(drawing_of("<style>a + path{fill:none}</style>" + path), {{0, 0}, {1, 1}});
}

TEST(SvgErrors, coordinates_out_of_range) {
  for (const char* data : {"M 0 0 L 1e300 1", "M 0 0 L 2e9 1", "M 0 0 C 1e308 0 1e308 1 0 1"})
    EXPECT_THAT(problem_of(svg_with(path_of(data))), HasSubstr(".svg:2")) << data;
  expect_problem(
      problem_of(svg_with("<g transform='scale(1e12)'>" + path_of("M 0 0 L 1 1") + "</g>")),
      ".svg:2", "beyond");
  EXPECT_NE(problem_of(svg_with(path_of("M 0 0 L 1e999 1"))), "");
}

TEST(SvgErrors, path_without_length) {
  for (const char* data : {"", "M 1 1", "M 1 1 L 1 1"})
    expect_problem(problem_of(svg_with(path_of(data))), ".svg:2", "no length");
  expect_problem(problem_of(svg_with("<path/>")), ".svg:2", "no length");
}

TEST(SvgErrors, a_million_nested_groups_are_walked) {
  std::string body;
  for (int i = 0; i < 1000000; ++i) body += "<g>";
  EXPECT_NE(problem_of(svg_with(body)), "");
}

std::vector<Depth> depths_of(const std::string& body, const std::string& id) {
  std::vector<Depth> depths;
  const auto paths = find_svg_paths(svg_with("<g id='band'>" + body + "</g>"), id);
  for (const SvgPath& path : paths.value()) depths.push_back(path.depth);
  return depths;
}

TEST(SvgDepth, is_told_by_the_class_of_a_path_or_its_group) {
  EXPECT_EQ(
      depths_of("<path class='thick behind'/><g class='front'><path/></g><path class='backwards'/>",
                "band"),
      (std::vector{Depth::behind, Depth::front, Depth::untold}));
}

TEST(SvgDepth, is_behind_for_dashed_strokes_among_others) {
  EXPECT_EQ(depths_of("<path stroke-dasharray='2 1'/><path style='stroke-dasharray: none'/>"
                      "<path style='fill:none; stroke-dasharray: 3, 1'/><path/>",
                      "band"),
            (std::vector{Depth::behind, Depth::untold, Depth::behind, Depth::untold}));
}

TEST(SvgDepth, rules_tell_of_dashes) {
  EXPECT_EQ(depths_of("<style>.st1{stroke-dasharray:4,2} .st2{stroke-dasharray:none}</style>"
                      "<path class='st1'/><path/><g class='st1'><path class='st2'/><path/></g>",
                      "band"),
            (std::vector{Depth::behind, Depth::untold, Depth::untold, Depth::behind}));
}

TEST(SvgDepth, is_untold_where_all_is_dashed) {
  EXPECT_EQ(depths_of("<g style='stroke-dasharray:2'><path/><path/></g>", "band"),
            (std::vector{Depth::untold, Depth::untold}));
}

TEST(SvgMarks, are_circles_with_an_id_that_are_seen) {
  const auto marks = find_svg_marks(svg_with(
      "<style>.st0{display:none}</style><circle r='3'/><circle id='a' class='st0'/>"
      "<g transform='translate(10 0) scale(2)'><circle id='b' cx=' 1.0px' cy=' -2.5e+0 '/></g>"
      "<ellipse id='c' cx='1e300'  transform='scale(0)'/>"));
  ASSERT_TRUE(marks.has_value()) << marks.error().sentence();
  ASSERT_EQ(marks->size(), 2U);
  EXPECT_EQ(marks->at(0).id, "b");
  EXPECT_EQ(marks->at(0).middle.value(), Vector2d(12, -5));
  EXPECT_EQ(marks->at(1).middle.value(), Vector2d(0, 0));
}

TEST(SvgMarks, with_units_are_told_where_they_are_asked_for) {
  for (const char* place :
       {"cx='10%'", "cy='3mm'", "cx='left'", "cx='1 2'", "cx='1 2 3'", "cx='1-2-3'", "cy=''",
        "cy='2L9 9'", "cy='1.5.5'", "cy='1e'", "cy='.'", "cy='nan'"}) {
    const auto marks =
        find_svg_marks(svg_with(std::string("<circle id='a' ") + place + "/><circle id='b'/>"));
    ASSERT_EQ(marks.value().size(), 2U) << place;
    expect_problem(refusal_of(marks->at(0).middle), ".svg:2: the middle of mark 'a' cannot be read",
                   "without a unit");
    EXPECT_EQ(marks->at(1).middle.value(), Vector2d(0, 0));
  }
  const auto far = find_svg_marks(svg_with("<circle id='a' cx='1e300'/>"));
  expect_problem(refusal_of(far.value().at(0).middle), ".svg:2", "beyond 1e9");
}

}  // namespace ribbon::drawing_test

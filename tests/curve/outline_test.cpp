#include "curve/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "result/refusal.h"

namespace ribbon::outline_test {

using Eigen::Vector2d;

// Of a tie: 30 wide, from 600 on growing to 50, from 1000 to its end at 1500 to 90.
double tie_width(double along) {
  if (along < 600) return 30;
  if (along < 1000) return 30 + (along - 600) / 20;
  return 50 + (along - 1000) * 0.08;
}

// From the upper left corner on, once round.
Drawing tie() {
  Drawing upper;
  Drawing lower;
  for (const double along : {0.0, 600.0, 1000.0, 1500.0}) {
    upper.emplace_back(along, -tie_width(along) / 2);
    lower.emplace_back(along, tie_width(along) / 2);
  }
  upper.insert(upper.end(), lower.rbegin(), lower.rend());
  return upper;
}

// Turned, and moved away from the origin.
Drawing turned(Drawing drawing, double angle) {
  for (Vector2d& point : drawing) point = Eigen::Rotation2Dd(angle) * point + Vector2d(-70, 4000);
  return drawing;
}

void expect_tie(const Drawing& outline) {
  const auto widths = widths_of(outline);
  ASSERT_TRUE(widths.has_value()) << widths.error().sentence();
  for (int i = 0; i <= 1000; ++i) {
    const double share = i / 1000.0;
    EXPECT_NEAR(width_at_m(*widths, share), tie_width(1500 * share), 0.09) << share;
  }
  EXPECT_LT(widths->points.size(), 60U);
}

TEST(Outline, of_a_tie_has_its_widths_to_a_thousandth_of_the_widest) {
  expect_tie(tie());
}

TEST(Outline, may_lie_at_any_slant_and_begin_at_any_corner) {
  for (const double angle : {-0.7, -0.3, 0.78, 1.2, 2.3}) expect_tie(turned(tie(), angle));
  for (std::size_t corner = 1; corner < tie().size(); ++corner) {
    Drawing other = tie();
    std::rotate(other.begin(), other.begin() + static_cast<std::ptrdiff_t>(corner), other.end());
    expect_tie(other);
    std::reverse(other.begin(), other.end());
    expect_tie(other);
  }
}

TEST(Outline, begins_at_its_left_end_and_upright_at_the_upper_one) {
  const auto first_width = [](double angle) {
    return width_at_m(widths_of(turned(tie(), angle)).value(), 0);
  };
  EXPECT_NEAR(first_width(0.7), 30, 0.1);
  EXPECT_NEAR(first_width(M_PI / 2), 30, 0.1);
  EXPECT_NEAR(first_width(M_PI), 90, 0.1);
  EXPECT_NEAR(first_width(-M_PI / 2), 90, 0.1);
}

TEST(Outline, of_a_band_of_one_width_is_two_points) {
  const auto widths = widths_of(turned({{0, 0}, {100, 0}, {100, 7}, {0, 7}}, 0.3)).value();
  ASSERT_EQ(widths.points.size(), 2U);
  EXPECT_NEAR(widths.points[0].width_m, 7, 1e-9);
  EXPECT_NEAR(widths.points[1].width_m, 7, 1e-9);
}

// With other corners in the middle of the upper edge, at (300, -15).
std::string refusal_with(const Drawing& corners) {
  Drawing outline = tie();
  outline.insert(outline.begin() + 1, corners.begin(), corners.end());
  return refusal_of(widths_of(outline));
}

TEST(Outline, that_doubles_back_is_refused_at_the_corner) {
  EXPECT_EQ(refusal_with({{300, -15}, {250, -20}}),
            "drawing at (250, -20): the outline doubles back, so that one place of the band has "
            "several widths; draw both sides so that they lead from one end to the other");
  EXPECT_EQ(refusal_with({{300, -15}, {299.5, -15}}), "") << "too little to matter";
}

TEST(Outline, whose_end_is_a_swallow_s_tail_is_refused) {
  EXPECT_THAT(refusal_of(widths_of({{0, -5}, {100, -5}, {90, 0}, {100, 5}, {0, 5}})),
              StartsWith("drawing at (90, 0): the outline doubles back"));
}

TEST(Outline, that_crosses_itself_is_refused) {
  EXPECT_THAT(refusal_of(widths_of({{0, -5}, {40, 5}, {100, 5}, {100, -5}, {40, -5}, {0, 5}})),
              HasSubstr("the outline has no width here: it crosses itself, or its sides meet"));
}

TEST(Outline, that_is_not_symmetric_is_refused_where_it_is_worst) {
  EXPECT_THAT(refusal_with({{300, -25}}), HasSubstr("not symmetric about its long axis: on one "));
  EXPECT_THAT(refusal_with({{300, -25}}), StartsWith("drawing at (300"));
  EXPECT_THAT(refusal_of(widths_of({{0, -5}, {100, -5}, {102, 5}, {0, 5}})),
              StartsWith("drawing at (10"))
      << "the slant of an end";
  EXPECT_EQ(refusal_with({{300, -16}}), "") << "by less than a fiftieth of its width";
}

TEST(Outline, that_is_not_long_is_refused) {
  const std::string no_axis = "the outline has no long axis";
  EXPECT_THAT(refusal_of(widths_of({{0, 0}, {19, 0}, {19, 10}, {0, 10}})), HasSubstr(no_axis));
  EXPECT_EQ(refusal_of(widths_of({{0, 0}, {21, 0}, {21, 10}, {0, 10}})), "");
  EXPECT_THAT(refusal_of(widths_of({{0, 0}, {5, 0}, {5, 5}, {0, 5}})), HasSubstr(no_axis));
}

// ---- As a scene names it

std::filesystem::path svg_with(const std::string& body) {
  auto file = temporary_file("tie.svg");
  EXPECT_TRUE(write_file(file, "<svg xmlns='http://www.w3.org/2000/svg'>\n" + body + "\n</svg>\n"));
  return file;
}

std::string scene_with(const std::string& ribbon) {
  return "[curve]\npoints = [[0, 0], [1000, 0]]\nunit = 0.0005\n[ribbon]\n" + ribbon +
         "along = 50\nacross = 3\n[time]\nduration = 1\n";
}

Result<Scene> read_with(const std::string& body, const std::string& ribbon) {
  return read_scene(svg_with(body).parent_path() / "knot.toml", scene_with(ribbon))
      .and_then(with_outline_read);
}

// As sentences begin without the folder.
std::string refusal(const std::string& body, const std::string& ribbon = "outline = 'tie.svg'\n") {
  std::string sentence = refusal_of(read_with(body, ribbon));
  const std::string folder = temporary_file("tie.svg").parent_path().string() + "/";
  for (std::size_t at; (at = sentence.find(folder)) != std::string::npos;)
    sentence.erase(at, folder.size());
  return sentence;
}

const std::string wedge = "<path id='tie' d='M0 0 L500 -40 V60 L0 20 Z'/>";

TEST(OutlineOfScene, becomes_a_list_of_widths_that_needs_no_drawing_any_more) {
  const Scene scene = read_with(wedge, "outline = 'tie.svg'  # as cut\n").value();
  EXPECT_FALSE(scene.ribbon.outline);
  EXPECT_NEAR(width_at_m(scene.ribbon, 0), 0.01, 0.05e-3) << "units of the curve";
  EXPECT_NEAR(width_at_m(scene.ribbon, 0.5), 0.03, 0.05e-3);
  EXPECT_NEAR(width_at_m(scene.ribbon, 1), 0.05, 0.05e-3);
  EXPECT_THAT(scene.text, HasSubstr("width = [[0, "));
  EXPECT_THAT(scene.text, HasSubstr("]]  # as cut\nalong = 50\n"));
  EXPECT_NEAR(scene.ribbon.width_m, 0.03, 0.05e-3) << "the mean";
  EXPECT_NEAR(scene.curve.clearance_m, 0.003, 0.01e-3);
  EXPECT_EQ(read_scene(scene.file, scene.text).value(), scene);
}

TEST(OutlineOfScene, leaves_as_it_is_what_was_changed_since_the_scene_was_read) {
  const auto file = svg_with(wedge).parent_path() / "knot.toml";
  Scene changed = read_scene(file, scene_with("outline = 'tie.svg'\n")).value();
  changed.name = "another";
  changed.time.duration_s = 2.5;
  changed.ribbon.along = 2;
  changed.curve.clearance_m = 0.007;
  const Scene scene = with_outline_read(changed).value();
  EXPECT_FALSE(scene.ribbon.outline);
  EXPECT_EQ(scene.name, "another");
  EXPECT_EQ(scene.time.duration_s, 2.5);
  EXPECT_EQ(scene.ribbon.along, 2);
  EXPECT_EQ(scene.curve.clearance_m, 0.007);
  EXPECT_EQ(scene.ribbon.width_m, mean_width_m(scene.ribbon)) << "of the rows that it has now";
}

TEST(OutlineOfScene, is_the_path_that_outline_path_names) {
  const std::string body = "<path id='knot' d='M0 0 H9'/>\n" + wedge;
  const std::string outline = "outline = 'tie.svg'\n";
  EXPECT_THAT(refusal(body), HasSubstr("write for example 'outline_path = \"knot\"' in the "
                                       "scene's [ribbon]"));
  EXPECT_EQ(refusal(body, outline + "outline_path = 'tie'\n"), "");
  EXPECT_THAT(refusal(body, outline + "outline_path = 'tei'\n"),
              HasSubstr("correct 'outline_path' in the scene's [ribbon]: there are 'knot', 'tie'"));
  EXPECT_EQ(refusal(body, outline + "outline_path = 'knot'\n"),
            "tie.svg:2: path 'knot' is open; close it: in Inkscape, select its two ends with the "
            "node tool and press Shift+J");
}

TEST(OutlineOfScene, of_one_width_is_that_width) {
  const Scene scene = read_with("<path d='M3 3 H103 V23 H3 Z'/>", "outline = 'tie.svg'\n").value();
  EXPECT_FALSE(scene.ribbon.profile);
  EXPECT_EQ(scene.ribbon.width_m, 0.01);
}

TEST(OutlineOfScene, may_be_curved_and_end_where_it_begins) {
  EXPECT_EQ(refusal("<path d='M0 -5 C30 -5 70 -20 100 -20 V20 C70 20 30 5 0 5 V-5'/>"), "");
}

TEST(OutlineOfScene, that_is_none_is_refused_with_its_line_and_its_place_in_the_drawing) {
  EXPECT_THAT(refusal("<path d='M0 -5 L100 -5 90 0 100 5 0 5 Z'/>"),
              StartsWith("tie.svg:2, drawing at (90, 0): the outline doubles back"));
  EXPECT_THAT(refusal("<path d='M0 0 H100 V9 H0 Z M20 3 H30 V5 H20 Z'/>"),
              StartsWith("tie.svg:2: the path has 2 pieces; draw the outline as one closed line"));
  EXPECT_THAT(refusal("<g id='both'>" + wedge + wedge + "</g>",
                      "outline = 'tie.svg'\noutline_path = 'both'\n"),
              HasSubstr("'both' is a group of several paths"));
  EXPECT_THAT(refusal(wedge, "outline = 'tei.svg'\n"),
              StartsWith("knot.toml:5:11: 'tei.svg' does not exist"));
}

TEST(OutlineOfScene, that_leaves_no_room_for_a_list_is_refused) {
  const auto file = svg_with(wedge).parent_path() / "knot.toml";
  const std::string scene =
      "curve = { points = [[0, 0], [1, 0]] }\ntime = { duration = 1 }\n"
      "ribbon = { along = 5, outline_path = 'tie', outline = 'tie.svg', across = 2 }\n";
  EXPECT_THAT(refusal_of(read_scene(file, scene).and_then(with_outline_read)),
              HasSubstr("write the tables of the scene as '[table]' lines"));
}

}  // namespace ribbon::outline_test

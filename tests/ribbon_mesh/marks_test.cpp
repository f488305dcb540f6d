#include "ribbon_mesh/marks.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "files/files.h"
#include "files/temporary_folder.h"

namespace ribbon::marks_test {

constexpr std::string_view drawing =
    "<svg xmlns='http://www.w3.org/2000/svg'>\n"
    "<path id='band' d='M0 0 H1000'/><path id='way' d='M0 0 V9'/>\n"
    "<circle id='quarter' cx='250' cy='4' r='3'/>\n"
    "</svg>\n";

constexpr std::string_view text =
    "[curve]\nsvg = 'band.svg'\npath = 'band'\n"
    "[knot]\nexpect = 'unknot'\nbetween = ['quarter', 1]\n"
    "[ribbon]\nwidth = 0.04\nalong = 101\nacross = 3\n"
    "[air]\nresistance = 10\n[fastening]\nspeed = 0.3\n"
    "[[stage]]\nat_most = 3\n"
    "[[stage.hand]]\nat = 'quarter'\npull = [1, 0, 0]\n"
    "[[stage.hand]]\nat = [0.9, 1]\ncarry = 'way'\n"
    "[time]\nduration = 4\n";

Scene marked_scene() {
  const auto svg = temporary_file("band.svg");
  EXPECT_TRUE(write_file(svg, std::string(drawing)));
  return read_scene(svg.parent_path() / "knot.toml", std::string(text)).value();
}

TEST(Marks, become_shares_and_points_that_need_no_drawing_any_more) {
  const Scene scene = with_marks_found(marked_scene()).value();
  const auto& hands = scene.stages[0].hands;
  EXPECT_NEAR(std::get<Span>(hands[0].at).begin, 0.23, 1e-9);
  EXPECT_NEAR(std::get<Span>(hands[0].at).end, 0.27, 1e-9) << "as much as it is wide";
  EXPECT_EQ(std::get<std::vector<Eigen::Vector2d>>(hands[1].carry.path).back(),
            Eigen::Vector2d(0, 9));
  EXPECT_EQ(std::get<double>(scene.knot->between->ends[0]), 0.25);
  EXPECT_EQ(read_scene(scene.file, scene.text).value(), scene);
}

TEST(Marks, that_are_not_there_are_told_where_the_file_or_a_setting_names_them) {
  const std::filesystem::path file = marked_scene().file;
  ASSERT_TRUE(write_file(file.parent_path() / "bare.svg",
                         "<svg xmlns='http://www.w3.org/2000/svg'>"
                         "<path id='band' d='M0 0 H1000'/></svg>"));
  const auto place_told = [&](const std::string& setting) {
    const Scene scene = read_scene(file, std::string(text), {setting}).value();
    const auto found = with_marks_found(scene);
    return found ? "" : found.error().place;
  };
  EXPECT_EQ(place_told("curve.svg=bare.svg"), file.string() + ":18:6");
  const std::string setting = "knot.between=[\"first\", 1]";
  EXPECT_EQ(place_told(setting), file.string() + " with '" + setting + "'");
}

TEST(Marks, leave_as_it_is_what_was_changed_since_the_scene_was_read) {
  Scene changed = marked_scene();
  changed.name = "another";
  changed.time.duration_s = 2.5;
  changed.stages[0].hands[0].speed_m_s = 0.7;
  changed.stages[0].hands.push_back(changed.stages[0].hands[0]);
  changed.stages[0].hands.back().at = Span{0.5, 0.6};
  const Scene scene = with_marks_found(changed).value();
  EXPECT_EQ(scene.name, "another");
  EXPECT_EQ(scene.time.duration_s, 2.5);
  EXPECT_EQ(scene.stages[0].hands[0].speed_m_s, 0.7);
  EXPECT_TRUE(std::holds_alternative<Span>(scene.stages[0].hands[0].at));
  EXPECT_EQ(scene.stages[0].hands[2], changed.stages[0].hands[2]);
}

}  // namespace ribbon::marks_test

#include "recorder/run/drawn_knot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

#include "knot/knot_witness.h"
#include "recorder/run/start.h"
#include "recorder/small_scene.h"
#include "result/refusal.h"
#include "ribbon_mesh/marks.h"
#include "text/number_text.h"

namespace ribbon::drawn_knot_test {

// Two strands wound round each other, as in crossings_test.cpp, with room for a ribbon.
constexpr const char* trefoil =
    "points = [[0, -100], [200, 100], [400, -100], [600, 100], [600, 400], [0, 400], [0, 100],\n"
    "          [200, -100], [400, 100], [600, -100]]\n";

Scene scene_of(const std::string& curve) {
  std::string text = small_scene_text();
  const std::size_t points = text.find("points");
  text.replace(points, text.find("[ribbon]") - points, curve);
  return read_scene("knot.toml", text).value();
}

Scene scene_with(const std::string& curve, const std::string& expect) {
  return scene_of(trefoil + curve + (expect.empty() ? "" : "[knot]\nexpect = '" + expect + "'\n"));
}

std::string refusal(const std::string& curve, const std::string& expect) {
  return refusal_of(find_start(scene_with(curve, expect), std::nullopt));
}

TEST(DrawnKnot, that_is_expected_is_accepted_under_all_its_names) {
  for (const char* name : {"trefoil", "overhand knot", "trefoil, right-handed"})
    EXPECT_EQ(refusal("", name), "") << name;
  EXPECT_EQ(refusal("crossings = 'OOOUUU'\n", "unknot"), "");
}

TEST(DrawnKnot, that_is_another_is_refused_with_what_it_ties_and_a_list_that_ties_it) {
  const std::string sentence = refusal("crossings = 'OOOUUU'\n", "trefoil, left-handed");
  EXPECT_THAT(sentence, StartsWith("knot.toml:7:10: the drawing ties: unknot; expected is: "
                                   "trefoil, left-handed; write 'crossings = \""));
  const std::size_t list = sentence.find("crossings = ");
  EXPECT_EQ(refusal(sentence.substr(list, sentence.find('\'', list) - list) + "\n",
                    "trefoil, left-handed"),
            "");
}

TEST(DrawnKnot, that_no_list_helps_is_refused_all_the_same) {
  EXPECT_THAT(refusal("", "reef knot"),
              HasSubstr("trefoil, right-handed (3 crossings); expected is: reef knot; correct"));
}

TEST(DrawnKnot, whose_name_nobody_knows_is_asked_for) {
  EXPECT_THAT(refusal("", "rief knot"), HasSubstr("no knot is known as 'rief knot'; did you mean "
                                                  "'reef knot'?"));
  EXPECT_THAT(refusal("", "figure-eight knot, left-handed"),
              HasSubstr("no knot is known as 'figure-eight knot, left-handed'; write 'expect = "
                        "\"figure-eight knot\"'"))
      << "it is its own mirror image";
  EXPECT_THAT(refusal("", "quetzalcoatlus"), HasSubstr("'expect = \"reef knot\"'"));
}

TEST(DrawnKnot, of_a_start_that_is_tied_otherwise_is_refused_with_both) {
  const Scene scene = scene_with("", "");
  const RibbonMesh drawn = draw_ribbon(scene).value();
  EXPECT_EQ(refusal_of(check_first_frame(scene, drawn, drawn.positions)), "");
  Eigen::Matrix3Xd mirrored = drawn.positions;
  mirrored.row(1) = -mirrored.row(1);
  EXPECT_THAT(refusal_of(check_first_frame(scene, drawn, mirrored)),
              AllOf(HasSubstr("at its start is tied as: trefoil, left-handed"),
                    HasSubstr("its drawing as: trefoil, right-handed")));
}

// Once round and a little more, outwards and in again, so that both ends lie within the loop: led
// out sideways, on two sides of it, they would make it a trefoil.
TEST(DrawnKnot, whose_ends_lie_within_its_loop_is_what_is_seen) {
  std::string points;
  for (int k = 0; k <= 40; ++k) {
    const double out = 80 + 170 * std::sin(std::numbers::pi * k / 40);
    const double turn = 2 * std::numbers::pi * 1.2 * k / 40;
    points += filled_in("{}[{:.1f}, {:.1f}]", k == 0 ? "" : ", ", out * std::cos(turn),
                        out * std::sin(turn));
  }
  for (const char* axis : {"x", "y", "z"}) {
    const Scene scene = scene_of(filled_in("points = [{}]\naxis = '{}'\n", points, axis));
    const RibbonMesh drawn = draw_ribbon(scene).value();
    EXPECT_EQ(refusal_of(check_first_frame(scene, drawn, drawn.positions)), "") << axis;
    KnotWitness closed_where_clearest(drawn.grid, std::nullopt);
    closed_where_clearest.follow(drawn.positions.cast<float>());
    EXPECT_THAT(closed_where_clearest.certificate().text(), HasSubstr("trefoil")) << axis;
    const RibbonMesh knotted = draw_ribbon(scene_with("", "")).value();
    ASSERT_EQ(knotted.grid, drawn.grid);
    EXPECT_THAT(refusal_of(check_first_frame(scene, drawn, knotted.positions)),
                HasSubstr("its drawing as: unknot"));
  }
}

// Of the gallery, with its marks found.
Scene bow_with(const std::vector<std::string>& settings) {
  const auto file = std::filesystem::path(RIBBON_SAMPLES) / "gallery/bow.toml";
  return with_marks_found(read_scene(file, settings).value()).value();
}

std::string refusal_of_bow(const std::vector<std::string>& settings) {
  const Scene scene = bow_with(settings);
  return refusal_of(check_expected_knot(scene, draw_ribbon(scene).value()));
}

// The second half knot the other way: a granny bow.
const std::string granny_bow = "curve.crossings=UUOOUUUUOOUUOUOUOUOOUUOOOOUUOO";

TEST(DrawnKnot, between_the_loops_tells_a_bow_from_a_granny_bow) {
  EXPECT_EQ(refusal_of_bow({}), "");
  EXPECT_THAT(refusal_of_bow({"knot.expect_between=granny knot"}),
              HasSubstr("between the two places the drawing ties: reef knot (6 crossings); "
                        "expected is: granny knot"));
  EXPECT_THAT(refusal_of_bow({granny_bow, "knot.expect=trefoil"}),
              HasSubstr("the drawing ties: granny knot"));
  EXPECT_EQ(refusal_of_bow({granny_bow, "knot.expect=trefoil", "knot.expect_between=granny knot"}),
            "");
}

TEST(DrawnKnot, of_a_part_is_named_by_what_it_closes_to) {
  EXPECT_THAT(refusal_of_bow({"knot.expect_between=bow"}),
              HasSubstr("'bow' is told by a drawing alone"));
  EXPECT_THAT(refusal_of_bow({"knot.expect_between=rief knot"}), HasSubstr("did you mean"));
  EXPECT_EQ(refusal_of_bow({"knot.between=[0, 1]", "knot.expect_between=trefoil"}), "");
}

TEST(DrawnKnot, of_a_part_at_the_start_is_compared_with_its_drawing) {
  const Scene reef = bow_with({});
  const RibbonMesh drawn = draw_ribbon(reef).value();
  EXPECT_EQ(refusal_of(check_first_frame(reef, drawn, drawn.positions)), "");
  const RibbonMesh granny = draw_ribbon(bow_with({granny_bow})).value();
  EXPECT_THAT(refusal_of(check_first_frame(reef, drawn, granny.positions)),
              HasSubstr("the part of the ribbon between the two places of 'between' at its start "
                        "is tied as: granny knot"));
  EXPECT_THAT(refusal_of(check_first_frame(bow_with({"knot.between=[0.5, 0.5001]"}), drawn,
                                           drawn.positions)),
              HasSubstr("no two rows lie between"));
}

}  // namespace ribbon::drawn_knot_test

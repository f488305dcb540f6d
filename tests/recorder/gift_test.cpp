// The gift ribbon of the gallery: drawn from above, it passes in front of its box and behind it.
#include <gtest/gtest.h>

#include <filesystem>

#include "files/temporary_folder.h"
#include "geometry/winding_number.h"
#include "obstacle/obstacle.h"
#include "recorder/run/drawn_knot.h"
#include "recorder/run/start.h"
#include "recorder/show_crossings.h"
#include "result/refusal.h"
#include "verification/frame_verifier.h"

namespace ribbon::gift_test {

Scene scene_with(const std::vector<std::string>& settings = {}) {
  return read_scene(std::filesystem::path(RIBBON_SAMPLES) / "gallery" / "gift.toml", settings)
      .value();
}

std::string refusal(const std::string& setting) {
  const Scene scene = scene_with({setting});
  return refusal_of(draw_ribbon(scene, read_obstacle(scene).value()));
}

TEST(Gift, passes_three_times_over_the_box_and_twice_beneath) {
  const Scene scene = scene_with();
  const RibbonMesh ribbon = draw_ribbon(scene, read_obstacle(scene).value()).value();
  std::string sides;
  for (const ObjectPassage& passage : ribbon.objects) sides += passage.in_front ? 'F' : 'B';
  EXPECT_EQ(sides, "FBFBF");
  EXPECT_EQ(letters_of(ribbon.crossings, ribbon.objects), scene.curve.crossings->letters);
  EXPECT_TRUE(check_expected_knot(scene, ribbon).has_value());
}

TEST(Gift, begins_free_of_intersections_and_tied_as_drawn) {
  const Scene scene = scene_with();
  const auto obstacle = read_obstacle(*scene.obstacle).value();
  const auto start = find_start(scene, obstacle);
  ASSERT_TRUE(start.has_value()) << start.error().sentence();
  EXPECT_EQ(start->fastening.start().kind, StartKind::free);
  const RibbonMesh& ribbon = start->ribbon;
  const FrameVerifier verifier(ribbon.size(), obstacle);
  const FrameVerdict verdict = verifier.verify(start->fastening.positions().cast<float>());
  EXPECT_TRUE(verdict.finite);
  EXPECT_TRUE(verdict.intersections.pairs.empty());
}

TEST(Gift, tied_otherwise_is_proposed_a_list_with_the_letters_of_the_box) {
  const Scene scene = scene_with({"knot.expect=\"figure-eight knot\""});
  const std::string sentence = refusal_of(find_start(scene, read_obstacle(scene).value()));
  const std::size_t begin = sentence.find("crossings = \"") + 13;
  std::string list = sentence.substr(begin, sentence.find('"', begin) - begin);
  std::erase_if(list, [](char letter) { return letter == 'O' || letter == 'U'; });
  EXPECT_EQ(list, "FBFBF") << sentence;
}

TEST(Gift, shown_with_its_passages_is_a_drawing_of_the_same) {
  const auto file = temporary_file("gift.svg");
  EXPECT_THAT(show_crossings(scene_with(), file, Older::is_replaced).value(),
              HasSubstr("crossings = \"" + scene_with().curve.crossings->letters + "\""));
  Scene drawn = scene_with();
  drawn.curve.drawing = DrawnSvg{{file}, "band"};
  drawn.curve.crossings.reset();
  EXPECT_THAT(show_crossings(drawn, temporary_file("again.svg"), Older::is_replaced).value(),
              HasSubstr("crossings = \"" + scene_with().curve.crossings->letters + "\""));
}

TEST(Gift, whose_list_does_not_tell_of_the_box_is_told_how_often_it_is_passed) {
  Scene scene = scene_with();
  std::erase_if(scene.curve.crossings->letters,
                [](char letter) { return letter == 'F' || letter == 'B'; });
  EXPECT_THAT(show_crossings(scene, temporary_file("gift.svg"), Older::is_replaced).value(),
              HasSubstr("passes the object 5 times"));
  scene.curve.drawing = DrawnPoints{{{-9000, 0}, {9000, 10}}};
  scene.curve.crossings.reset();
  EXPECT_THAT(show_crossings(scene, temporary_file("straight.svg"), Older::is_replaced).value(),
              HasSubstr("passes the object once"));
}

TEST(Gift, with_a_letter_too_few_is_told_where) {
  EXPECT_THAT(refusal("curve.crossings=\"OFUOOUUOOUUUUFOOUOBUUUUOUFOOUOOO\""),
              AllOf(HasSubstr("gift.toml with "), HasSubstr("the curve passes the object from (9"),
                    HasSubstr("letter 9 of 'crossings' is O; write F as letter 9")));
}

TEST(Gift, round_a_box_too_high_for_its_turns_is_told_which_way_is_too_short) {
  EXPECT_THAT(refusal("obstacle.scale=0.99"), "");
  const Scene scene = scene_with();
  TriangleMesh tower = read_obstacle(*scene.obstacle).value();
  tower.vertices.row(1) *= 6;
  EXPECT_THAT(refusal_of(draw_ribbon(scene, tower)),
              AllOf(StartsWith("drawing at ("), HasSubstr("that passes the object"),
                    HasSubstr("drawing units long")));
}

TEST(Gift, has_a_closed_box_with_its_outside_outwards) {
  const Scene scene = scene_with();
  const TriangleMesh box = read_obstacle(*scene.obstacle).value();
  EXPECT_NEAR(winding_number(box, {0, 0, 0}), 1, 1e-6);
}

}  // namespace ribbon::gift_test

// What a drawing is, as a knot diagram.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "obstacle/obstacle.h"
#include "recorder/page/drawn_diagram.h"
#include "recorder/small_scene.h"

namespace ribbon::diagram_json_test {

using ::testing::HasSubstr;

Scene drawn(const std::string& points) {
  Scene scene = read_scene("small.toml", small_scene_text()).value();
  return read_scene("small.toml", "[curve]\npoints = " + points + "\n" +
                                      scene.text.substr(scene.text.find("[ribbon]")))
      .value();
}

nlohmann::json diagram(const Scene& scene,
                       const std::optional<TriangleMesh>& obstacle = std::nullopt) {
  return nlohmann::json::parse(diagram_json(scene, obstacle).value());
}

TEST(DiagramJson, tells_crossings_letters_and_the_knot) {
  const auto scene = read_scene(RIBBON_SAMPLES "/overhand-cylinder-8x400.toml").value();
  const auto told = diagram(scene, read_obstacle(scene).value());
  EXPECT_EQ(told["letters"], "OUOUOU");
  EXPECT_THAT(told["knot"], HasSubstr("trefoil"));
  EXPECT_EQ(told["problem"], "");
  ASSERT_EQ(told["crossings"].size(), 3U);
  for (const auto& crossing : told["crossings"]) EXPECT_LT(crossing["first"], crossing["second"]);
  EXPECT_TRUE(told["crossings"][0]["first_over"]);
  EXPECT_FALSE(told["crossings"][1]["first_over"]);
}

TEST(DiagramJson, an_exchanged_crossing_ties_nothing) {
  auto scene = read_scene(RIBBON_SAMPLES "/overhand-cylinder-8x400.toml").value();
  scene.curve.crossings = CrossingList{"OOOUUU"};
  EXPECT_THAT(diagram(scene)["knot"], HasSubstr("unknot"));
}

TEST(DiagramJson, crossings_are_told_where_over_and_under_cannot_be) {
  auto scene = read_scene(RIBBON_SAMPLES "/overhand-cylinder-8x400.toml").value();
  scene.curve.crossings = CrossingList{"OU"};
  const auto told = diagram(scene);
  EXPECT_EQ(told["crossings"].size(), 3U);
  EXPECT_EQ(told["knot"], "");
  EXPECT_THAT(told["problem"], HasSubstr("passages"));
}

TEST(DiagramJson, what_is_no_diagram_is_refused_with_its_place) {
  const auto refused =
      diagram_json(drawn("[[0, 0], [100, 0], [100, 50], [50, 50], [50, 0], [50, -50]]"), {});
  ASSERT_TRUE(refused) << "a strand that crosses another at a corner does cross it";
  const auto touching =
      diagram_json(drawn("[[0, 0], [100, 0], [100, 50], [50, 0], [0, 50]]"), std::nullopt);
  EXPECT_THAT(touching.error().sentence(), HasSubstr("drawing at (50, 0)"));
}

TEST(DiagramJson, a_curve_through_the_object_is_told_with_the_place) {
  const auto scene = read_scene(RIBBON_SAMPLES "/overhand-cylinder-8x400.toml").value();
  Scene through = drawn("[[-1000, 0], [1000, 0]]");
  const auto told = diagram(through, read_obstacle(scene).value());
  EXPECT_THAT(told["problem"], HasSubstr("drawing at (0, 0): the curve leads through the object"));
}

TEST(DiagramJson, passes_of_the_object_are_told_with_their_letters) {
  const auto scene = read_scene(RIBBON_SAMPLES "/overhand-cylinder-8x400.toml").value();
  const auto cylinder = read_obstacle(scene).value();
  Scene through = drawn("[[-1000, 0], [1000, 0], [1000, 500], [100, 500], [100, -500]]");
  auto told = diagram(through, cylinder);
  ASSERT_EQ(told["passes"].size(), 2U);
  EXPECT_NEAR(told["passes"][0]["begin"], 0.4, 0.001) << "the outline is 200 mm from the middle";
  EXPECT_NEAR(told["passes"][0]["end"], 0.6, 0.001);
  EXPECT_NEAR(told["passes"][0]["at"][0], -200, 1);
  EXPECT_TRUE(told["passes"][0]["in_front"]);
  EXPECT_TRUE(told["passes"][1]["in_front"]);
  EXPECT_EQ(told["letters"], "OU");
  EXPECT_THAT(told["problem"], HasSubstr("leads through the object"));
  through.curve.crossings = CrossingList{"FOBU"};
  told = diagram(through, cylinder);
  EXPECT_EQ(told["letters"], "FOBU");
  EXPECT_EQ(told["problem"], "");
  EXPECT_TRUE(told["passes"][0]["in_front"]);
  EXPECT_FALSE(told["passes"][1]["in_front"]);
  through.curve.crossings = CrossingList{"FOU"};
  EXPECT_THAT(diagram(through, cylinder)["problem"], HasSubstr("passes the object"));
}

TEST(DiagramJson, letters_of_the_object_where_there_is_none_are_refused) {
  Scene through = drawn("[[-1000, 0], [1000, 0]]");
  through.curve.crossings = CrossingList{"F"};
  EXPECT_THAT(diagram(through)["problem"], HasSubstr("there is none"));
}

TEST(Silhouette, is_the_object_as_seen_from_the_axis) {
  const auto scene = read_scene(RIBBON_SAMPLES "/overhand-cylinder-8x400.toml").value();
  const auto cylinder = read_obstacle(scene).value();
  const auto corners = silhouette(*cylinder, scene.curve);
  ASSERT_EQ(corners.size(), 2 * static_cast<std::size_t>(cylinder->triangles.size()));
  float farthest = 0;
  for (std::size_t i = 0; i < corners.size(); i += 2)
    farthest = std::max(farthest, std::hypot(corners[i], corners[i + 1]));
  EXPECT_NEAR(farthest, 200, 0.1) << "millimetres";
}

}  // namespace ribbon::diagram_json_test

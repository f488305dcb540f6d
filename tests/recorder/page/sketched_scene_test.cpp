// A scene with another drawing than it was written with.
#include "recorder/page/sketched_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recorder/small_scene.h"
#include "scene/scene.h"

namespace ribbon::sketched_scene_test {

using ::testing::HasSubstr;

TEST(SketchedScene, draws_the_sketch_and_stays_what_it_was) {
  const auto text =
      sketched_scene("small.toml", small_scene_text(), "OU", {"ribbon.along=80"}).value();
  const auto scene = read_scene("small.toml", text).value();
  Scene wanted = read_scene("small.toml", small_scene_text()).value();
  EXPECT_EQ(std::get<DrawnSvg>(scene.curve.drawing).file.path.filename(), sketched_drawing);
  EXPECT_EQ(scene.curve.crossings->letters, "OU");
  EXPECT_EQ(scene.ribbon.along, 80);
  wanted.ribbon.along = 80;
  wanted.curve = scene.curve;
  wanted.text = scene.text;
  EXPECT_EQ(scene, wanted);
}

TEST(SketchedScene, letters_of_an_older_drawing_go) {
  const auto once = sketched_scene("small.toml", small_scene_text(), "OU", {}).value();
  const auto again = sketched_scene("small.toml", once, "", {}).value();
  EXPECT_FALSE(read_scene("small.toml", again)->curve.crossings);
}

TEST(SketchedScene, what_is_no_setting_is_refused) {
  const auto refused = sketched_scene("small.toml", small_scene_text(), "", {"width"});
  EXPECT_THAT(refused.error().sentence(), HasSubstr("'width' is not a setting"));
}

}  // namespace ribbon::sketched_scene_test

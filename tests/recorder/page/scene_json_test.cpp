// Scenes as the page in which one draws takes them in.
#include "recorder/page/scene_json.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "curve/outline.h"
#include "files/temporary_folder.h"

namespace ribbon::scene_json_test {

nlohmann::json taken_in(const std::string& sample) {
  return nlohmann::json::parse(
      scene_json(read_scene(std::filesystem::path(RIBBON_SAMPLES) / sample).value())
          .value()
          .line());
}

TEST(SceneJson, tells_over_and_under_of_a_drawing_that_does_not_alternate) {
  EXPECT_EQ(taken_in("gallery/reef.toml")["letters"], "OUOOUOUOUUOU");
  EXPECT_EQ(taken_in("overhand-cylinder-8x400.toml")["letters"], "OUOUOU");
}

TEST(SceneJson, tells_what_passes_in_front_of_the_object_and_what_behind) {
  EXPECT_EQ(taken_in("gallery/gift.toml")["letters"], "OFUOOUUOBOUUUUFOOUOBUUUUOUFOOUOOO");
}

// The page has the scene's text, but no drawing of its outline.
TEST(SceneJson, tells_the_widths_of_an_outline_so_that_its_drawing_is_not_needed) {
  const std::string text = taken_in("gallery/four-in-hand.toml")["text"];
  const auto alone = read_scene(temporary_file("sketch.toml"), text).and_then(with_outline_read);
  ASSERT_TRUE(alone) << alone.error().sentence();
  EXPECT_TRUE(alone->ribbon.profile);
}

}  // namespace ribbon::scene_json_test

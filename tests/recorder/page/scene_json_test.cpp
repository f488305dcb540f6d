// Scenes as the page in which one draws takes them in.
#include "recorder/page/scene_json.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

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

}  // namespace ribbon::scene_json_test

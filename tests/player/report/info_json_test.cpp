#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "files/files.h"
#include "player/report/info.h"

namespace ribbon::info_json_test {

RecordingInfo two_frames() {
  RecordingInfo info;
  info.file = "knot.rbn";
  info.header.scene_name = "obi";
  info.header.grid = {10, 4};
  info.header.obstacle =
      TriangleMesh{"stone", Eigen::Matrix3Xf::Zero(3, 6), Eigen::Matrix3Xi::Zero(3, 8)};
  info.numbers = {FrameNumbers{0.5, 0.25, 7, 3}, std::nullopt};
  info.missing = {2};
  info.damage = {{2000, 150, "checksum differs"}};
  return info;
}

TEST(InfoJson, programs_read_what_people_read) {
  const auto json = nlohmann::json::parse(info_json(two_frames()));
  EXPECT_EQ(json["scene"]["name"], "obi");
  EXPECT_EQ(json["ribbon"]["across"], 4);
  EXPECT_EQ(json["ribbon"]["narrowest_m"], json["ribbon"]["width_m"]);
  EXPECT_EQ(json["ribbon"]["widest_m"], json["ribbon"]["width_m"]);
  EXPECT_EQ(json["obstacle"]["triangles"], 8);
  EXPECT_EQ(json["frame_count"], 2);
  EXPECT_EQ(json["worst_strain"]["value"], 0.25);
  EXPECT_EQ(json["penetrating_edges"]["worst"]["frame"], 1);
  EXPECT_EQ(json["missing_frames"], nlohmann::json::array({2}));
  EXPECT_EQ(json["damage"][0]["byte"], 2000);
  EXPECT_EQ(json["frames"][0]["recovery_iterations"], 3);
}

TEST(InfoJson, is_documented) {
  const std::string documented =
      read_file(std::filesystem::path(RIBBON_REFERENCES) / "../../../docs/play.md").value();
  const auto json = nlohmann::json::parse(info_json(two_frames()));
  for (const auto& [field, value] : json.items())
    EXPECT_NE(documented.find("`" + field + "`"), std::string::npos) << field;
}

TEST(InfoJson, what_is_not_known_is_null) {
  RecordingInfo info = two_frames();
  EXPECT_TRUE(nlohmann::json::parse(info_json(info))["frames"][1]["time_s"].is_null());
  info.numbers.clear();
  info.header.obstacle.reset();
  const auto json = nlohmann::json::parse(info_json(info));
  EXPECT_TRUE(json["input_curve"].is_null());
  EXPECT_TRUE(json["obstacle"].is_null());
  EXPECT_TRUE(json["centre_axis"].is_null());
  EXPECT_TRUE(json["stated_gap_m"].is_null());
  EXPECT_TRUE(json["strain_limit"].is_null());
  EXPECT_TRUE(json["limited_edges"].empty());
  EXPECT_TRUE(json["worst_strain"].is_null());
  EXPECT_TRUE(json["penetrating_edges"]["last"].is_null());
}

TEST(InfoJson, what_the_writer_states_is_told) {
  RecordingInfo info = two_frames();
  info.header.stated_gap_m = 0.25;
  info.header.limited_edges.diagonals = true;
  info.header.strain_limit = 0.125;
  info.header.centre_axis = CentreAxis{{0.5, 0, -1}, {0, 1, 0}};
  info.header.input_curve.setZero(3, 400);
  const auto json = nlohmann::json::parse(info_json(info));
  EXPECT_EQ(json["stated_gap_m"], 0.25);
  EXPECT_EQ(json["input_curve"]["points"], 400);
  EXPECT_EQ(json["strain_limit"], 0.125);
  EXPECT_EQ(json["limited_edges"], nlohmann::json::array({"diagonal"}));
  EXPECT_EQ(json["centre_axis"]["point_m"], nlohmann::json::array({0.5, 0.0, -1.0}));
  EXPECT_EQ(json["centre_axis"]["direction"], nlohmann::json::array({0.0, 1.0, 0.0}));
}

TEST(InfoJson, tightness_and_ending_are_told_or_null) {
  RecordingInfo info = two_frames();
  auto json = nlohmann::json::parse(info_json(info));
  EXPECT_TRUE(json["ending"].is_null());
  EXPECT_TRUE(json["frames"][0]["tightness"].is_null());
  info.ending = RunEnding::duration;
  info.numbers[0]->tightness = TightnessNumbers{0.5F, 0.25F, 1, 0.75F, 12.5F};
  json = nlohmann::json::parse(info_json(info));
  EXPECT_EQ(json["ending"], "duration");
  const nlohmann::json expected = {{"progress", 0.5},
                                   {"truncated", 0.25},
                                   {"pull", 1.0},
                                   {"contact", 0.75},
                                   {"rope_length", 12.5}};
  EXPECT_EQ(json["frames"][0]["tightness"], expected);
  EXPECT_TRUE(json["frames"][1]["tightness"].is_null());
}

TEST(InfoJson, how_the_recording_came_about_is_told) {
  RecordingInfo info = two_frames();
  auto json = nlohmann::json::parse(info_json(info));
  EXPECT_TRUE(json["origin"].is_null());
  EXPECT_TRUE(json["sessions"].empty());
  EXPECT_EQ(json["being_written"], false);
  info.header.origin = Origin{7, "mother", 77, "a = 1\n"};
  info.sessions = {{1, {SessionReason::extended, "ribbon-record 0.2.0", "b = 2\n"}}};
  info.checkpoints = {1, 2};
  info.being_written = true;
  json = nlohmann::json::parse(info_json(info));
  EXPECT_EQ(json["origin"]["frame"], 78);
  EXPECT_EQ(json["origin"]["scene"], "mother");
  EXPECT_EQ(json["sessions"][0]["reason"], "extended");
  EXPECT_EQ(json["sessions"][0]["first_frame"], 2);
  EXPECT_EQ(json["checkpoints"], nlohmann::json::array({1, 2}));
  EXPECT_EQ(json["being_written"], true);
}

TEST(InfoJson, names_that_are_not_utf8_still_give_json) {
  RecordingInfo info = two_frames();
  info.header.scene_name = "\xFFobi";
  EXPECT_EQ(nlohmann::json::parse(info_json(info))["scene"]["name"], "\xEF\xBF\xBDobi");
}

}  // namespace ribbon::info_json_test

#include "recorder/run/run_statistics.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "files/files.h"
#include "result/refusal.h"

namespace ribbon::run_statistics_test {

RunStatistics example() {
  RunStatistics statistics{.scene_name = "knot", .along = 10, .across = 4, .start = "grown"};
  statistics.add(
      {.time_s = 0, .worst_strain = 0.3, .penetrating_edges = 5, .recovery_iterations = 0});
  statistics.add(
      {.time_s = 1, .worst_strain = 0.1, .penetrating_edges = 2, .recovery_iterations = 7});
  statistics.integrator = "rk4";
  statistics.steps = 100;
  statistics.computed_steps = 100;
  statistics.phases.parts = 400;
  statistics.simulation_s = 4;
  statistics.bytes = 160;
  return statistics;
}

TEST(RunStatistics, keep_the_worst_and_the_last) {
  const RunStatistics statistics = example();
  EXPECT_EQ(statistics.worst_strain, 0.3);
  EXPECT_EQ(statistics.last_strain, 0.1);
  EXPECT_EQ(statistics.worst_penetrating_edges, 5U);
  EXPECT_EQ(statistics.last_penetrating_edges, 2U);
  EXPECT_EQ(statistics.recovery_iterations, 7U);
  EXPECT_EQ(statistics.steps_per_second(), 25);
  // By hand: 160 bytes are 1280 bits for 40 vertices in 2 frames.
  EXPECT_EQ(statistics.bits_per_vertex_and_frame(), 16);
}

TEST(RunStatistics, of_a_run_that_did_nothing_divide_by_nothing) {
  EXPECT_EQ(RunStatistics{}.steps_per_second(), 0);
  EXPECT_EQ(RunStatistics{}.substeps(), 0);
  EXPECT_EQ(RunStatistics{}.bits_per_vertex_and_frame(), 0);
}

TEST(RunStatistics, fit_on_one_line) {
  EXPECT_EQ(
      summary_line(example()),
      "grown start; 2 frames, 1.0 s in 100 steps (25.0 steps/s); worst strain of a spring 30.0 %; "
      "penetrating edges 5 "
      "at worst, 2 at last; 0.0 MB (16.0 bits per vertex and frame)");
}

TEST(RunStatistics, tell_to_what_edges_were_held_where_that_is_little) {
  RunStatistics statistics = example();
  statistics.held_strain = 0.088;
  EXPECT_THAT(summary_line(statistics), HasSubstr("worst strain of a spring 30.0 %; "));
  statistics.held_strain = 0.0281;
  EXPECT_THAT(summary_line(statistics),
              HasSubstr("worst strain of a spring 30.0 % (edges are held to 2.8 %, as recorded "
                        "coordinates are coarse); "));
}

TEST(RunStatistics, tell_where_the_time_went) {
  RunStatistics statistics = example();
  statistics.phases.time_s = {0.1, 0.4, 2, 0.5, 0.6, 0.4, 0};
  statistics.phases.detections = 150;
  statistics.phases.listed_pairs = 123'400;
  statistics.phases.sweeps = 1230;
  statistics.measuring_s = 0.75;
  statistics.recording_s = 0.25;
  statistics.beside_it.writer = {.encoding_s = 0.5, .writing_s = 0.1, .syncing_s = 0.05};
  statistics.beside_it.longest_queue = 3;
  // By hand: 5 s in all, so detection takes 40 % and 20 ms of each of 100 steps.
  EXPECT_EQ(
      profile_text(statistics),
      "a step, 100 times, by rk4 in 4.0 parts:\n"
      "  fastening force     2.0 %      1.000 ms\n"
      "  integration         8.0 %      4.000 ms\n"
      "  detection          40.0 %     20.000 ms\n"
      "  repulsion          10.0 %      5.000 ms\n"
      "  strain correction  12.0 %      6.000 ms\n"
      "  truncation          8.0 %      4.000 ms\n"
      "a frame, 2 times:\n"
      "  measuring          15.0 %    375.000 ms\n"
      "  recording           5.0 %    125.000 ms\n"
      "beside these, of the same time:\n"
      "  encoding           10.0 %    250.000 ms\n"
      "  writing             2.0 %     50.000 ms\n"
      "  syncing             1.0 %     25.000 ms\n"
      "in a step 1.50 detections, 1234 pairs of features listed, 12.3 sweeps over all edges\n");
}

TEST(RunStatistics, are_told_to_programs_as_json) {
  const auto json = nlohmann::json::parse(statistics_json(example()));
  EXPECT_EQ(json["scene"], "knot");
  EXPECT_EQ(json["start"], "grown");
  EXPECT_EQ(json["integrator"], "rk4");
  EXPECT_EQ(json["substeps"], 4);
  EXPECT_EQ(json["steps"], 100);
  EXPECT_EQ(json["worst_penetrating_edges"], 5);
  EXPECT_EQ(json["ending"], "unknown");
  EXPECT_EQ(json["phases"]["detection_s"], 0);
  EXPECT_EQ(json["phases"]["strain_correction_s"], 0);
  EXPECT_TRUE(json["tightness"].is_null());
}

TEST(RunStatistics, are_documented) {
  const std::string documented =
      read_file(std::filesystem::path(RIBBON_SAMPLES) / "../docs/play.md").value();
  const auto json = nlohmann::json::parse(statistics_json(example()));
  for (const auto& [field, value] : json.items())
    EXPECT_THAT(documented, HasSubstr("`" + field + "`")) << value;
}

// By hand: 100 of 150 steps in 4 s; 1 s of 5 s for the recording.
TEST(RunStatistics, of_a_run_that_went_on_tell_what_it_did_itself) {
  RunStatistics statistics = example();
  statistics.steps = 150;
  statistics.frames_before = 1;
  statistics.recording_s = 1;
  statistics.beside_it.longest_queue = 7;
  EXPECT_EQ(statistics.steps_per_second(), 25);
  EXPECT_EQ(statistics.share_of_recording(), 0.2);
  const auto json = nlohmann::json::parse(statistics_json(statistics));
  EXPECT_EQ(json["steps"], 150);
  EXPECT_EQ(json["computed_steps"], 100);
  EXPECT_EQ(json["frames_before"], 1);
  EXPECT_EQ(json["recording_share"], 0.2);
  EXPECT_EQ(json["longest_queue"], 7);
  EXPECT_THAT(profile_text(statistics), StartsWith("a step, 100 times,"));
  EXPECT_THAT(profile_text(statistics), HasSubstr("a frame, 1 times:"));
}

RunStatistics tight() {
  RunStatistics statistics = example();
  statistics.until_tight = true;
  statistics.ending = RunEnding::tight;
  statistics.add({.time_s = 2,
                  .worst_strain = 0.1,
                  .penetrating_edges = 0,
                  .recovery_iterations = 0,
                  .tightness = TightnessNumbers{0.0215F, 0, 0.125F, 0.5F, 12.25F}});
  return statistics;
}

TEST(RunStatistics, say_why_a_run_ended) {
  RunStatistics statistics = tight();
  EXPECT_THAT(summary_line(statistics),
              EndsWith("; ended tight: progress 2.2 %, rope length 12.2 widths"));
  statistics.ending = RunEnding::duration;
  EXPECT_THAT(summary_line(statistics), HasSubstr("; not yet tight: progress 2.2 %"));
  statistics.until_tight = false;
  EXPECT_THAT(summary_line(statistics), EndsWith("per vertex and frame)"));
  statistics.ending = RunEnding::stopped;
  EXPECT_THAT(summary_line(statistics), EndsWith("; ended early by the user"));
  statistics.ending = RunEnding::limit;
  EXPECT_THAT(summary_line(statistics), EndsWith("; ended at 2.0 s, as asked"));
}

TEST(RunStatistics, of_a_short_run_tell_how_short_it_is) {
  RunStatistics statistics;
  statistics.add({.time_s = 1 / 30.0});
  EXPECT_THAT(summary_line(statistics), HasSubstr("; 1 frames, 0.0333 s in 0 steps"));
}

TEST(RunStatistics, tell_programs_how_tight_the_last_frame_is) {
  const auto json = nlohmann::json::parse(statistics_json(tight()));
  EXPECT_EQ(json["ending"], "tight");
  EXPECT_EQ(json["tightness"]["contact"], 0.5);
  EXPECT_EQ(json["tightness"]["rope_length"], 12.25);
}

}  // namespace ribbon::run_statistics_test

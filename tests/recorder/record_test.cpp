#include "recorder/record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "files/temporary_folder.h"
#include "playback/recording_reader.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"
#include "result/refusal.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "verification/largest_strain.h"

namespace ribbon::record_test {

namespace fs = std::filesystem;

class Record : public TestInFolder {
 protected:
  void SetUp() override { scene_ = read_scene(write_small_scene(folder_)).value(); }
  [[nodiscard]] RunStatistics record_all(const fs::path& file) const {
    return record(scene_, replacing(file), goes_on).value();
  }

  [[nodiscard]] RecordingReader recorded() const {
    return RecordingReader::open(folder_ / "knot.rbn").value();
  }

  Scene scene_;
};

// By hand: 0.2 s are frames at 0, 1/30, ... 6/30 s of four steps of 8.3 ms, and likewise.
TEST_F(Record, each_frame_is_recorded_at_its_time) {
  struct Rate {
    const char* setting;
    double frames_per_second;
    int frames;
    int steps;
  };
  for (const Rate& rate : {Rate{"recording.frames_per_second=30", 30, 7, 24},
                           Rate{"recording.frames_per_second=24", 24, 5, 20},
                           Rate{"recording.frames_per_second=60", 60, 13, 24},
                           Rate{"recording.frames_per_second=23.976", 23.976, 5, 20},
                           Rate{"recording.frames_per_second=120", 120, 25, 24}}) {
    scene_ = read_scene(folder_ / "small.toml", std::vector<std::string>{rate.setting}).value();
    const RunStatistics statistics = record_all(folder_ / "knot.rbn");
    EXPECT_EQ(frame_count(scene_), rate.frames) << rate.setting;
    EXPECT_EQ(statistics.frames, rate.frames) << rate.setting;
    EXPECT_EQ(statistics.steps, rate.steps) << rate.setting;
    const auto reader = recorded();
    ASSERT_EQ(reader.frame_count(), rate.frames) << rate.setting;
    for (int frame = 0; frame < rate.frames; ++frame)
      EXPECT_NEAR(reader.numbers(frame)->time_s, frame / rate.frames_per_second, 1e-12)
          << rate.setting << ", frame " << frame;
  }
}

TEST_F(Record, a_frame_between_two_steps_is_recorded_at_the_second) {
  scene_.time.step_s = 0.01;
  EXPECT_EQ(record_all(folder_ / "knot.rbn").steps, 20);
  const auto reader = recorded();
  constexpr std::array expected_s = {0.0, 0.04, 0.07, 0.1, 0.14, 0.17, 0.2};
  for (int frame = 0; frame < 7; ++frame)
    EXPECT_NEAR(reader.numbers(frame)->time_s, expected_s[frame], 1e-12);
}

TEST_F(Record, the_header_says_what_was_recorded) {
  (void)record_all(folder_ / "knot.rbn");
  const auto reader = recorded();
  const RecordingHeader& header = reader.header();
  EXPECT_TRUE(reader.finished());
  EXPECT_EQ(header.scene_name, "small loop");
  EXPECT_EQ(header.scene_text, small_scene_text());
  EXPECT_EQ(header.writer, "test");
  EXPECT_EQ(header.grid, (RibbonGrid{60, 4}));
  EXPECT_EQ(header.frames_per_second, 30);
  EXPECT_EQ(header.ribbon_width_m, 0.03);
  EXPECT_NEAR(header.max_position_error_m, 1e-5 * header.ribbon_length_m, 1e-15);
  EXPECT_FALSE(header.obstacle.has_value());
  EXPECT_EQ(header.centre_axis, (CentreAxis{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()}));
}

TEST_F(Record, the_header_tells_the_curve_that_the_ribbon_was_put_on) {
  (void)record_all(folder_ / "knot.rbn");
  const Eigen::Matrix3Xf drawn = draw_ribbon(scene_)->curve.cast<float>();
  ASSERT_EQ(drawn.cols(), 60);
  EXPECT_EQ(recorded().header().input_curve, drawn);
}

// Sixteen particles across are 2 mm apart; rounding by 2e-5 of the length may move the ends of such
// an edge by 5 % of it. Hands that do not yield strain the ribbon as far as they are let.
TEST_F(Record, a_fine_ribbon_is_recorded_within_the_strain_limit) {
  scene_.ribbon.across = 16;
  scene_.fastening->speed_m_s = 3;
  scene_.fastening->yield_strain = unyielding;
  scene_.recording.max_position_error = 2e-5;
  (void)record_all(folder_ / "fine.rbn");
  auto reader = RecordingReader::open(folder_ / "fine.rbn").value();
  const RecordingHeader& header = reader.header();
  EXPECT_GT(2 * std::sqrt(3) * header.max_position_error_m, 0.04 * header.ribbon_width_m / 15);
  Eigen::Matrix3Xf positions;
  double worst = 0;
  for (int frame = 0; frame < reader.frame_count(); ++frame) {
    ASSERT_TRUE(reader.read(frame, positions).has_value());
    const double strain = largest_strain(rest_size(header), header.limited_edges, positions).strain;
    EXPECT_LE(strain, 0.1) << frame;
    worst = std::max(worst, strain);
  }
  EXPECT_GT(worst, 0.06);  // or it would have stayed within it anyway
}

// Pulled as above, measured by the rows' widths as the file tells them.
TEST_F(Record,
       a_ribbon_with_a_width_profile_is_recorded_with_its_rows_and_within_the_strain_limit) {
  const std::vector<std::string> settings = {"ribbon.width=[[0, 0.015], [0.5, 0.02], [1, 0.045]]",
                                             "ribbon.along=120", "fastening.speed=3"};
  scene_ = read_scene(scene_.file, settings).value();
  (void)record_all(folder_ / "knot.rbn");
  auto reader = recorded();
  const RecordingHeader& header = reader.header();
  EXPECT_EQ(header.row_widths_m, row_widths_m(scene_.ribbon));
  EXPECT_EQ(header.row_widths_m.front(), 0.015F);
  EXPECT_EQ(header.row_widths_m.back(), 0.045F);
  Eigen::Matrix3Xf positions;
  double by_mean = 0;
  for (int frame = 0; frame < reader.frame_count(); ++frame) {
    ASSERT_TRUE(reader.read(frame, positions).has_value());
    const double strain = largest_strain(rest_size(header), header.limited_edges, positions).strain;
    EXPECT_LE(strain, 0.1) << frame;
    const RestSize mean{header.grid, header.ribbon_length_m, header.ribbon_width_m};
    by_mean = std::max(by_mean, largest_strain(mean, header.limited_edges, positions).strain);
  }
  EXPECT_GT(by_mean, 0.4) << "or the profile had no effect";
}

TEST_F(Record, a_profile_of_one_width_gives_the_same_frames_as_the_number) {
  (void)record_all(folder_ / "number.rbn");
  const std::vector<std::string> settings = {"ribbon.width=[[0, 0.03], [1, 0.03]]"};
  scene_.ribbon = read_scene(scene_.file, settings).value().ribbon;
  (void)record_all(folder_ / "profile.rbn");
  EXPECT_EQ(read_file(folder_ / "number.rbn").value(), read_file(folder_ / "profile.rbn").value());
}

TEST_F(Record, the_header_names_the_edges_that_are_limited) {
  const auto header_with = [&](ContactMethod contact, double shear) {
    scene_.contact = contact;
    scene_.springs.shear = shear;
    (void)record_all(folder_ / "knot.rbn");
    return recorded().header();
  };
  EXPECT_EQ(header_with(ContactMethod::gate, 10).limited_edges, (LimitedEdges{true, true, true}));
  EXPECT_EQ(recorded().header().strain_limit, 0.1);
  EXPECT_EQ(header_with(ContactMethod::gate, 0).limited_edges, (LimitedEdges{true, true, false}));
  EXPECT_EQ(recorded().header().strain_limit, 0.1);
  EXPECT_EQ(header_with(ContactMethod::paper, 10).limited_edges, (LimitedEdges{true, true, false}));
  EXPECT_EQ(recorded().header().strain_limit, 0);
}

TEST_F(Record, ends_early_when_asked_and_says_so) {
  const auto statistics =
      record(scene_, replacing(folder_ / "knot.rbn"),
             {[](int done, int total, const FrameNumbers&) { return done < 3 || total != 7; }})
          .value();
  EXPECT_EQ(statistics.ending, RunEnding::stopped);
  const auto reader = recorded();
  EXPECT_EQ(reader.ending(), RunEnding::stopped);
  EXPECT_EQ(reader.frame_count(), 3);
  EXPECT_TRUE(reader.finished());
}

TEST_F(Record, every_frame_tells_how_tight_the_ribbon_is) {
  scene_.fastening->yield_strain = unyielding;
  (void)record_all(folder_ / "knot.rbn");
  const auto reader = recorded();
  EXPECT_EQ(reader.ending(), RunEnding::duration);
  EXPECT_EQ(reader.numbers(0)->tightness->progress, 1) << "nothing was commanded yet";
  EXPECT_EQ(reader.numbers(0)->tightness->pull, 1);
  for (int frame = 1; frame < 7; ++frame) {
    const std::optional<TightnessNumbers> tightness = reader.numbers(frame)->tightness;
    ASSERT_TRUE(tightness.has_value());
    EXPECT_GT(tightness->progress, 0.5) << "free";
    EXPECT_LT(tightness->progress, 1.5);
    EXPECT_EQ(tightness->pull, 1) << "hands that never yield";
  }
}

TEST_F(Record, what_nothing_fastens_has_no_tightness) {
  scene_.fastening.reset();
  (void)record_all(folder_ / "knot.rbn");
  const auto reader = recorded();
  EXPECT_FALSE(reader.numbers(6)->tightness.has_value());
}

TEST_F(Record, a_run_until_tight_ends_by_itself) {
  scene_.obstacle = ObstacleScene{.file = {write_square_post(folder_)}};
  scene_.time = {.step_s = 0.01, .duration_s = 60, .until = RunsUntil::tight};
  scene_.fastening->speed_m_s = 0.5;
  scene_.fastening->yield_strain = 0.05;
  scene_.recording.frames_per_second = 10;
  const RunStatistics statistics = record_all(folder_ / "knot.rbn");
  EXPECT_EQ(statistics.ending, RunEnding::tight);
  EXPECT_GT(statistics.simulated_s, 2);
  EXPECT_LT(statistics.simulated_s, 30);
  const auto reader = recorded();
  EXPECT_EQ(reader.ending(), RunEnding::tight);
  ASSERT_EQ(reader.frame_count(), statistics.frames);
  const TightnessNumbers last = *reader.numbers(statistics.frames - 1)->tightness;
  EXPECT_LT(std::abs(last.progress), 0.03);
  EXPECT_GT(last.contact, 0);
  for (int frame = 21; frame + 1 < statistics.frames; ++frame)
    EXPECT_GE(std::abs(reader.numbers(frame)->tightness->progress), 0.03) << frame;
}

TEST_F(Record, an_obstacle_that_cannot_be_read_is_named_before_anything_is_written) {
  scene_.obstacle = ObstacleScene{.file = {folder_ / "missing.obj"}};
  EXPECT_THAT(refusal_of(record(scene_, replacing(folder_ / "knot.rbn"), goes_on)),
              HasSubstr("missing.obj"));
  EXPECT_FALSE(fs::exists(folder_ / "knot.rbn"));
}

TEST_F(Record, a_scene_without_a_free_start_leaves_an_older_recording_as_it_was) {
  const fs::path file = folder_ / "knot.rbn";
  (void)record_all(file);
  const std::string before = read_file(file).value();
  scene_.ribbon.width_m = 50;
  scene_.curve.clearance_m = 5;
  const RunObserver observer{[](int, int, const FrameNumbers&) { return true; }};
  const std::string sentence = refusal_of(record(scene_, replacing(file), observer));
  EXPECT_THAT(sentence, StartsWith("small loop: "));
  EXPECT_THAT(sentence, HasSubstr("row "));
  EXPECT_THAT(sentence, HasSubstr("drawing at ("));
  EXPECT_THAT(sentence, HasSubstr("ribbon.width"));
  EXPECT_TRUE(read_file(file).value() == before);
  const auto refused = record(scene_, replacing(folder_ / "new.rbn"), observer);
  EXPECT_FALSE(refused.has_value());
  EXPECT_FALSE(fs::exists(folder_ / "new.rbn"));
}

TEST_F(Record, a_ribbon_too_wide_for_the_crossing_is_grown_and_states_its_gap) {
  scene_.ribbon.width_m = 0.4;
  scene_.curve.clearance_m = 0.04;
  const RunStatistics statistics = record_all(folder_ / "knot.rbn");
  EXPECT_EQ(statistics.start, "grown");
  EXPECT_GT(statistics.start_s, 0);
  EXPECT_EQ(statistics.worst_penetrating_edges, 0U);
  EXPECT_GT(recorded().header().stated_gap_m, 0);
}

TEST_F(Record, as_published_too_wide_a_ribbon_is_refused_by_its_drawing) {
  scene_.contact = ContactMethod::paper;
  scene_.ribbon.width_m = 2;
  EXPECT_THAT(refusal_of(record(scene_, replacing(folder_ / "knot.rbn"), goes_on)),
              HasSubstr("too short for a ribbon"));
}

TEST_F(Record, recoveries_of_the_start_are_in_the_first_frame) {
  // A needle through the band.
  const fs::path needle = folder_ / "needle.obj";
  ASSERT_TRUE(write_file(needle,
                         "v -0.001 0 -0.4\nv 0.001 0 -0.4\nv 0 0.002 -0.4\nv 0 0 0\n"
                         "f 1 3 2\nf 2 3 4\nf 4 3 1\nf 1 2 4\n")
                  .has_value());
  scene_.obstacle = ObstacleScene{.file = {needle}};
  scene_.contact = ContactMethod::paper;
  const RunStatistics statistics = record_all(folder_ / "knot.rbn");
  EXPECT_EQ(statistics.start, "recovered");
  const auto reader = recorded();
  EXPECT_GT(reader.numbers(0)->recovery_iterations, 0U);
  EXPECT_EQ(reader.header().stated_gap_m, 0);
}

}  // namespace ribbon::record_test

#include "player/report/info.h"

#include <gtest/gtest.h>

#include "result/refusal.h"

namespace ribbon::info_test {

// Three frames recorded, the second lost.
RecordingInfo three_frames() {
  RecordingInfo info;
  info.file = "knot.rbn";
  info.file_bytes = 6000;
  info.finished = true;
  info.header.scene_name = "obi";
  info.header.writer = "ribbon-record 0.1.0";
  info.header.grid = {10, 4};
  info.header.ribbon_length_m = 2;
  info.header.ribbon_width_m = 0.08;
  info.header.frames_per_second = 25;
  info.header.max_position_error_m = 2e-5;
  info.numbers = {FrameNumbers{1, 0.02, 7, 3}, std::nullopt, FrameNumbers{1.08, 0.0415, 2, 5}};
  info.missing = {2};
  info.damage = {{2000, 150, "checksum differs"}};
  return info;
}

TEST(RecordingInfo, sums_up_the_frames_that_are_known) {
  const RecordingInfo info = three_frames();
  EXPECT_EQ(info.frame_count(), 3);
  EXPECT_NEAR(info.duration_s(), 0.08, 1e-12);
  EXPECT_EQ(info.worst_strain()->value, 0.0415);
  EXPECT_EQ(info.worst_strain()->frame, 3);
  EXPECT_EQ(info.most_penetrations()->value, 7);
  EXPECT_EQ(info.most_penetrations()->frame, 1);
  EXPECT_EQ(info.last_penetrations(), 2U);
  EXPECT_EQ(info.bytes_per_vertex_and_frame(), 6000.0 / 3 / 40);
}

TEST(RecordingInfo, without_frames_there_is_nothing_to_sum_up) {
  RecordingInfo info = three_frames();
  info.numbers.clear();
  EXPECT_EQ(info.duration_s(), 0);
  EXPECT_FALSE(info.worst_strain());
  EXPECT_FALSE(info.last_penetrations());
  EXPECT_EQ(info.bytes_per_vertex_and_frame(), 0);
  EXPECT_THAT(info_text(info), HasSubstr("0 in 0.00 s"));
}

TEST(RecordingInfo, tells_from_where_to_where_the_width_goes) {
  RecordingInfo info = three_frames();
  EXPECT_THAT(info_text(info), HasSubstr("4 x 10 particles, 0.08 m wide, 2 m long\n"));
  info.header.row_widths_m.assign(10, 0.08);
  info.header.row_widths_m.front() = 0.06;
  info.header.row_widths_m.back() = 0.1;
  EXPECT_THAT(info_text(info),
              HasSubstr("4 x 10 particles, 0.06 to 0.1 m wide, 0.08 m in the mean, "
                        "2 m long\n"));
}

// A number that the header does not name is nobody's.
TEST(RecordingInfo, tells_the_frames_of_each_stage) {
  RecordingInfo info = three_frames();
  info.header.stages = {"half knot", "bow"};
  for (const int stage : {1, 2, 2, 3}) {
    info.numbers.emplace_back(FrameNumbers{2, 0, 0, 0});
    info.numbers.back()->stage = static_cast<std::uint8_t>(stage);
  }
  EXPECT_THAT(info_text(info), HasSubstr("stage           half knot, frames 4 to 4\n"
                                         "stage           bow, frames 5 to 6\n"));
  EXPECT_EQ(info.stages().size(), 2U);
}

// As in a take whose hands grip again; a lost frame does not tell so.
TEST(RecordingInfo, frames_of_no_stage_part_a_stage) {
  RecordingInfo info;
  info.header.stages = {"carry"};
  for (const int stage : {1, 1, 0, 0, 1, 1}) {
    info.numbers.emplace_back(FrameNumbers{2, 0, 0, 0});
    info.numbers.back()->stage = static_cast<std::uint8_t>(stage);
  }
  info.numbers.insert(info.numbers.begin() + 1, std::nullopt);
  EXPECT_THAT(info_text(info), HasSubstr("stage           carry, frames 1 to 3\n"
                                         "stage           carry, frames 6 to 7\n"));
  EXPECT_EQ(info.stages().size(), 2U);
}

TEST(RecordingInfo, the_text_is_readable) {
  EXPECT_EQ(info_text(three_frames()),
            "recording       knot.rbn\n"
            "scene           obi\n"
            "written by      ribbon-record 0.1.0\n"
            "frames          3 in 0.08 s, 25 per second\n"
            "checkpoints     none\n"
            "ribbon          4 x 10 particles, 0.08 m wide, 2 m long\n"
            "input curve     none\n"
            "obstacle        none\n"
            "centre axis     none\n"
            "gap             none stated\n"
            "strain limit    none stated\n"
            "worst strain    4.2 % in frame 3\n"
            "penetrations    at most 7, in frame 1; in the last frame 2\n"
            "position error  at most 0.02 mm\n"
            "size            6000 bytes, 50.00 per vertex and frame\n"
            "damage          150 bytes at byte 2000: checksum differs\n"
            "lost frames     2\n");
}

TEST(RecordingInfo, what_the_writer_states_is_told) {
  RecordingInfo info = three_frames();
  info.header.stated_gap_m = 0.00025;
  info.header.limited_edges = {.along = true, .across = true};
  info.header.centre_axis = CentreAxis{{0.5, 0, -1}, {0, 1, 0}};
  info.header.input_curve.setZero(3, 400);
  const std::string text = info_text(info);
  EXPECT_THAT(text, HasSubstr("gap             at least 0.25 mm, as stated\n"));
  EXPECT_THAT(text, HasSubstr("centre axis     through (0.5, 0, -1) m along (0, 1, 0)\n"));
  EXPECT_THAT(text, HasSubstr("input curve     400 points\n"));
  EXPECT_THAT(text, HasSubstr("strain limit    none stated for edges along and across\n"));
  info.header.strain_limit = 0.1;
  EXPECT_THAT(info_text(info),
              HasSubstr("strain limit    10 %, as stated for edges along and across\n"));
}

TEST(RecordingInfo, tightness_and_ending_are_told) {
  RecordingInfo info = three_frames();
  EXPECT_FALSE(info.last_tightness());
  info.ending = RunEnding::tight;
  info.numbers[2]->tightness = TightnessNumbers{-0.0125F, 0.5F, 0.25F, 0.375F, 12.25F};
  EXPECT_EQ(info.last_tightness()->contact, 0.375F);
  const std::string text = info_text(info);
  EXPECT_THAT(text, HasSubstr("ended           when the ribbon was tight\n"));
  EXPECT_THAT(text, HasSubstr("last frame      progress -1.2 %, pull 25.0 %, truncated 50.0 %\n"
                              "                in contact 37.5 %, rope length 12.2 widths\n"));
  info.outcome = {.embraces_object = true, .knot_distance_m = 0.0008};
  EXPECT_THAT(info_text(info),
              HasSubstr("tight\noutcome         round the object, the knot 0.8 mm from it\n"));
  info.ending = RunEnding::stopped;
  EXPECT_THAT(info_text(info), HasSubstr("ended           early, as the user asked\n"));
  info.ending = RunEnding::limit;
  EXPECT_THAT(info_text(info), HasSubstr("ended           at the limit that was asked for\n"));
}

TEST(RecordingInfo, where_a_run_was_taken_up_again_is_told) {
  RecordingInfo info = three_frames();
  info.header.origin = Origin{7, "mother", 77, "a = 1\nb = 2\n"};
  info.sessions = {{0, {SessionReason::begun, "ribbon-record 0.1.0", "a = 1\n"}},
                   {1, {SessionReason::resumed, "ribbon-record 0.1.0", ""}},
                   {2, {SessionReason::extended, "ribbon-record 0.2.0", "time.duration = 9\n"}}};
  info.checkpoints = {1, 2, 3};
  const std::string text = info_text(info);
  EXPECT_THAT(text, HasSubstr("branch of       mother, from its frame 78, with a = 1 b = 2\n"));
  EXPECT_THAT(
      text,
      HasSubstr("begun           at frame 1 by ribbon-record 0.1.0, with a = 1\n"
                "resumed         at frame 2 by ribbon-record 0.1.0\n"
                "extended        at frame 3 by ribbon-record 0.2.0, with time.duration = 9\n"));
  EXPECT_THAT(text, HasSubstr("checkpoints     3, at frames 1, 2, 3\n"));
  info.checkpoints = {1, 20, 30, 40, 50, 60, 70, 80};
  EXPECT_THAT(info_text(info),
              HasSubstr("checkpoints     8, at frames 1, 20, 30, ..., 60, 70, 80\n"));
}

TEST(RecordingInfo, exact_positions_are_told) {
  RecordingInfo info = three_frames();
  info.header.max_position_error_m = 0;
  EXPECT_THAT(info_text(info),
              HasSubstr("position error  none beyond rounding to single precision\n"));
}

TEST(RecordingInfo, a_recorder_at_work_is_mentioned) {
  RecordingInfo info = three_frames();
  info.finished = false;
  info.being_written = true;
  EXPECT_THAT(info_text(info), HasSubstr("25 per second; more are being recorded\n"));
}

TEST(RecordingInfo, a_stopped_recorder_is_mentioned) {
  RecordingInfo info = three_frames();
  info.finished = false;
  EXPECT_THAT(info_text(info), HasSubstr("; the recorder was stopped on the way"));
}

}  // namespace ribbon::info_test

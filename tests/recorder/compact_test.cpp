#include "recorder/compact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

#include "commandline/tool_run.h"
#include "continuation/resume_recording.h"
#include "files/flipped.h"
#include "playback/frames_of.h"
#include "recorder/process.h"
#include "recorder/record.h"
#include "recorder/resume.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"
#include "recording/codec/entropy_tables.h"
#include "recording/sample_recording.h"
#include "recording/size_limit.h"
#include "recording/writer/recording_writer.h"

namespace ribbon::compact_test {

namespace fs = std::filesystem;

constexpr int frames = 150;  // some groups, the last one not full

// The sample's ribbon in waves, so that there is something to predict.
Eigen::Matrix3Xd waves(int frame) {
  Eigen::Matrix3Xd positions = sample_positions(frame / 4);
  for (Eigen::Index p = 0; p < positions.cols(); ++p)
    positions(1, p) += 0.02 * std::sin(0.11 * frame + 0.05 * static_cast<double>(p));
  return positions;
}

class Compacted : public ToolTest {
 protected:
  Compacted() : ToolTest(RIBBON_RECORD) {}

  void record_waves(const RecordingHeader& header, Ending ending = Ending::finished) {
    auto writer = RecordingWriter::create(file_, header).value();
    for (int frame = 0; frame < frames; ++frame) {
      ASSERT_TRUE(writer.append(sample_numbers(frame), waves(frame)).has_value());
      if (frame % 20 == 0) {
        ASSERT_TRUE(writer.append_checkpoint(10UL * static_cast<unsigned>(frame),
                                             "state " + std::to_string(frame)));
      }
      if (frame == 70) {
        ASSERT_TRUE(writer.append_session({SessionReason::resumed, "tests", "a = 1\n"}));
      }
    }
    if (ending == Ending::finished) {
      ASSERT_TRUE(writer.finish(RunEnding::tight).has_value());
    }
  }
  void record_waves() {
    RecordingHeader header = sample_header();
    header.entropy_tables = standard_entropy_tables();
    record_waves(header);
  }

  [[nodiscard]] std::string refusal() const { return refusal_of(compact(file_)); }

  fs::path file_ = folder_ / "knot.rbn";
};

TEST_F(Compacted, every_frame_has_the_same_bits_and_the_file_is_smaller) {
  for (const double bound_m : {1e-5, 0.0}) {
    RecordingHeader header = sample_header();
    header.max_position_error_m = bound_m;
    header.quantisation_step_m = quantisation_step_m(bound_m, 1);
    record_waves(header);
    const auto before = frames_of(file_);
    const std::uintmax_t bytes_before = fs::file_size(file_);
    const auto id = RecordingReader::open(file_)->recording_id();
    const auto compaction = compact(file_).value();
    EXPECT_EQ(compaction, (Compaction{frames, bytes_before, fs::file_size(file_)}));
    EXPECT_LT(fs::file_size(file_), bytes_before * 96 / 100);
    auto reader = RecordingReader::open(file_).value();
    EXPECT_EQ(frames_of(reader), before);
    reader.check();
    EXPECT_TRUE(reader.damage().empty());
    EXPECT_EQ(frames_of(reader), before);
    EXPECT_EQ(reader.recording_id(), id) << "branches know it by that";
    EXPECT_EQ(names(".").size(), 1U);
  }
}

TEST_F(Compacted, sessions_ending_and_the_checkpoints_that_are_needed_stay) {
  record_waves();
  const auto sessions = RecordingReader::open(file_)->sessions();
  ASSERT_EQ(sessions.size(), 1U);
  ASSERT_EQ(refusal(), "");
  const auto reader = RecordingReader::open(file_).value();
  EXPECT_EQ(reader.sessions(), sessions);
  EXPECT_TRUE(reader.finished());
  EXPECT_EQ(reader.ending(), RunEnding::tight);
  EXPECT_EQ(reader.frame_count(), frames);
  auto checkpoints = reader.checkpoints();
  std::sort(checkpoints.begin(), checkpoints.end());
  EXPECT_EQ(checkpoints, (std::vector<std::uint32_t>{0, 120, 140}));
  EXPECT_EQ(*reader.read_checkpoint(140), (Checkpoint{140, 1400, "state 140"}));
}

TEST_F(Compacted, a_jump_shows_what_playing_shows) {
  record_waves();
  const auto truth = frames_of(file_);
  ASSERT_EQ(refusal(), "");
  std::mt19937 random(7);
  auto reader = RecordingReader::open(file_).value();
  Eigen::Matrix3Xf positions;
  for (int jump = 0; jump < 400; ++jump) {
    const int frame = static_cast<int>(random() % frames);
    if (jump % 10 == 0) reader = RecordingReader::open(file_).value();
    ASSERT_TRUE(reader.read(frame, positions).has_value());
    ASSERT_EQ(positions, truth[frame].positions) << frame;
  }
}

// Plain frames help no others; those around them must do without.
TEST_F(Compacted, frames_beyond_the_reach_of_quantised_positions_stay_as_they_are) {
  {
    auto writer = RecordingWriter::create(file_, sample_header()).value();
    for (int frame = 0; frame < frames; ++frame) {
      const double scale = frame % 16 == 3 || frame == 64 ? 1e30 : 1;
      Eigen::Matrix3Xd positions = waves(frame);
      if (scale > 1) positions = (scale * positions).cast<float>().cast<double>();
      ASSERT_TRUE(writer.append(sample_numbers(frame), positions).has_value()) << frame;
    }
    ASSERT_TRUE(writer.finish().has_value());
  }
  const auto before = frames_of(file_);
  ASSERT_EQ(refusal(), "");
  EXPECT_EQ(frames_of(file_), before);
}

TEST_F(Compacted, recordings_of_few_frames_work) {
  for (int count = 0; count < 6; ++count) {
    write_sample_recording(file_, count);
    const auto before = frames_of(file_);
    ASSERT_EQ(refusal(), "") << count;
    EXPECT_EQ(frames_of(file_), before);
  }
}

TEST_F(Compacted, what_is_compact_stays_byte_for_byte) {
  record_waves();
  ASSERT_EQ(refusal(), "");
  const std::string once = bytes("knot.rbn");
  const auto again = compact(file_).value().value();
  EXPECT_EQ(again.bytes_after, again.bytes_before);
  EXPECT_TRUE(bytes("knot.rbn") == once);
  EXPECT_EQ(names(".").size(), 1U);
}

TEST_F(Compacted, one_that_a_kill_left_behind_stays_one_that_can_be_resumed) {
  record_waves(sample_header(), Ending::killed);
  std::ofstream(file_, std::ios::binary | std::ios::app) << "\xB1REC torn";
  const auto before = frames_of(file_);
  ASSERT_EQ(refusal(), "");
  EXPECT_EQ(frames_of(file_), before);
  EXPECT_FALSE(RecordingReader::open(file_)->finished());
}

TEST_F(Compacted, it_grows_again_and_is_compacted_again) {
  record_waves();
  ASSERT_EQ(refusal(), "");
  {
    auto writer = resume_recording(file_).value();
    EXPECT_EQ(writer.frames_written(), static_cast<std::uint32_t>(frames));
    ASSERT_TRUE(writer.append_session({SessionReason::extended, "tests", ""}).has_value());
    for (int frame = frames; frame < 2 * frames; ++frame)
      ASSERT_TRUE(writer.append(sample_numbers(frame), waves(frame)).has_value());
    ASSERT_TRUE(writer.finish(RunEnding::duration).has_value());
  }
  const auto grown = frames_of(file_);
  const auto bytes_grown = fs::file_size(file_);
  EXPECT_EQ(grown.size(), 2U * frames);
  ASSERT_EQ(refusal(), "");
  EXPECT_LT(fs::file_size(file_), bytes_grown);
  EXPECT_EQ(frames_of(file_), grown);
  EXPECT_EQ(RecordingReader::open(file_)->sessions().size(), 2U);
}

TEST_F(Compacted, a_run_goes_on_behind_it_to_the_same_bits) {
  write_small_scene(folder_);
  const Scene scene = read_scene(folder_ / "small.toml").value();
  ASSERT_TRUE(record(scene, replacing(folder_ / "whole.rbn"), goes_on, {.frames = 61}).has_value());
  const auto whole = frames_of(folder_ / "whole.rbn");
  ASSERT_TRUE(record(scene, replacing(file_), goes_on, {.frames = 40}).has_value());
  ASSERT_LT(compact(file_).value()->bytes_after, fs::file_size(folder_ / "whole.rbn"));
  ASSERT_TRUE(resume(file_, "test", goes_on, {.frames = 61}).has_value());
  EXPECT_EQ(frames_of(file_), whole);
}

// Wherever the disk is full: in the header, in frames, at the end.
TEST_F(Compacted, a_full_disk_leaves_the_recording_as_it_was) {
  record_waves();
  const std::string before = bytes("knot.rbn");
  const fs::path copy = folder_ / "small.rbn";
  fs::copy_file(file_, copy);
  const std::uint64_t needed = compact(copy).value()->bytes_after;
  fs::remove(copy);
  for (const std::uint64_t room : {std::uint64_t{100}, needed / 3, needed - 100, needed - 1}) {
    const SizeLimit limit(room);
    EXPECT_THAT(refusal(), HasSubstr("cannot be compacted")) << room;
    EXPECT_TRUE(bytes("knot.rbn") == before) << room;
    EXPECT_EQ(names(".").size(), 1U) << room;
  }
  EXPECT_EQ(refusal(), "");
}

TEST_F(Compacted, given_up_it_leaves_the_recording_as_it_was) {
  record_waves();
  const std::string before = bytes("knot.rbn");
  const auto gives_up = [](int done, int) { return done < 30; };
  for (const CompactionObserver& observer :
       {CompactionObserver{gives_up, {}}, CompactionObserver{{}, gives_up}}) {
    const auto answer = compact(file_, observer);
    ASSERT_TRUE(answer.has_value()) << answer.error().sentence();
    EXPECT_FALSE(answer->has_value());
    EXPECT_TRUE(bytes("knot.rbn") == before);
    EXPECT_EQ(names(".").size(), 1U);
  }
}

// In a process of its own, at moments that fall into writing, comparing and putting in place.
TEST_F(Compacted, a_kill_leaves_a_whole_recording) {
  record_waves();
  const auto before = frames_of(file_);
  const std::string original = bytes("knot.rbn");
  std::mt19937 random(3);
  for (unsigned kill = 0; kill < 15; ++kill) {
    ASSERT_TRUE(write_file(file_, original).has_value());
    const pid_t tool = spawned({RIBBON_RECORD, "--compact", file_.string(), "--quiet"});
    ASSERT_GT(tool, 0);
    std::this_thread::sleep_for(std::chrono::microseconds(2000) * kill +
                                std::chrono::microseconds(random() % 2000));
    ::kill(tool, SIGKILL);
    (void)waited_for(tool);
    ASSERT_EQ(frames_of(file_), before);
    EXPECT_EQ(RecordingReader::open(file_)->ending(), RunEnding::tight);
  }
  ASSERT_TRUE(write_file(file_, original).has_value());
  ASSERT_EQ(refusal(), "") << "what kills have left beside it is in nobody's way";
  EXPECT_LT(fs::file_size(file_), original.size());
}

TEST_F(Compacted, no_writer_can_have_it_meanwhile) {
  record_waves();
  int refused = 0;
  const auto try_to_write = [&](int, int) {
    refused += resume_recording(file_) ? 0 : 1;
    return true;
  };
  ASSERT_TRUE(compact(file_, {try_to_write, try_to_write}).has_value());
  EXPECT_EQ(refused, 2 * frames);
  const auto writer = resume_recording(file_).value();
  const std::string busy = bytes("knot.rbn");
  EXPECT_THAT(refusal(), HasSubstr("is being written by another program"));
  EXPECT_TRUE(bytes("knot.rbn") == busy);
}

TEST_F(Compacted, a_damaged_one_is_refused) {
  record_waves();
  const std::string whole = bytes("knot.rbn");
  for (const std::size_t at : {std::size_t{2}, whole.size() / 3, whole.size() / 2}) {
    const std::string damaged = flipped(whole, at, 0x20);
    ASSERT_TRUE(write_file(file_, damaged).has_value());
    EXPECT_THAT(refusal(), HasSubstr("knot.rbn: is damaged"));
    EXPECT_TRUE(bytes("knot.rbn") == damaged);
  }
}

TEST_F(Compacted, what_is_no_recording_is_told_and_left_as_it_is) {
  ASSERT_TRUE(write_file(file_, "a letter").has_value());
  EXPECT_THAT(refusal(), HasSubstr("is not a ribbon recording"));
  EXPECT_EQ(bytes("knot.rbn"), "a letter");
  file_ = folder_ / "missing.rbn";
  EXPECT_THAT(refusal(), HasSubstr("missing.rbn"));
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(Compacted, links_and_permissions_stay) {
  record_waves();
  fs::permissions(file_, fs::perms::owner_read | fs::perms::owner_write);
  const fs::path link = folder_ / "link.rbn";
  fs::create_symlink("knot.rbn", link);
  const auto before = fs::file_size(file_);
  ASSERT_TRUE(compact(link).has_value());
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_LT(fs::file_size(file_), before);
  EXPECT_EQ(fs::status(file_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Compacted, the_tool_compacts_alone_and_behind_a_run) {
  write_small_scene(folder_);
  ASSERT_EQ(run("small.toml -o one.rbn --frames 40 --quiet").exit_code, 0);
  const auto before = frames_of(folder_ / "one.rbn");
  EXPECT_THAT(output_of(run("--compact one.rbn")),
              StartsWith("one.rbn: compacted, 40 frames as they were"));
  EXPECT_EQ(frames_of(folder_ / "one.rbn"), before);
  EXPECT_EQ(run("small.toml -o two.rbn --frames 40 --compact").exit_code, 0);
  EXPECT_EQ(fs::file_size(folder_ / "two.rbn"), fs::file_size(folder_ / "one.rbn"));
  EXPECT_EQ(run("--resume two.rbn --frames 61 --compact").exit_code, 0);
  EXPECT_EQ(first_difference(before, frames_of(folder_ / "two.rbn")), -1);
}

TEST_F(Compacted, what_does_not_go_with_it_is_told) {
  expect_refusal(run("--compact"), "nothing to compact");
  for (const char* const more : {"--until 3", "--frames 9", "--stats x.json", "--profile",
                                 "--force", "--set fastening.speed=1"})
    expect_refusal(run("--compact knot.rbn " + std::string(more)), "--compact alone");
  expect_refusal(run("--compact missing.rbn"), "missing.rbn");
}

}  // namespace ribbon::compact_test

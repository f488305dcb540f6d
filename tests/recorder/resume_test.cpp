#include "recorder/resume.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "files/flipped.h"
#include "files/temporary_folder.h"
#include "playback/frames_of.h"
#include "playback/unfinished.h"
#include "recorder/branch.h"
#include "recorder/record.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"
#include "recording/writer/recording_writer.h"
#include "result/refusal.h"
#include "scene/setting.h"

namespace ribbon::resume_test {

namespace fs = std::filesystem;

class ResumeRun : public TestInFolder {
 protected:
  void SetUp() override {
    file_ = folder_ / "knot.rbn";
    (void)write_file(folder_ / "knot.toml", small_scene_text("2") + "checkpoint_every = 0.5\n");
    scene_ = read_scene(folder_ / "knot.toml").value();
    (void)record(scene_, replacing(folder_ / "whole.rbn"), goes_on);
    whole_ = frames_of(folder_ / "whole.rbn");
  }
  // Ends after so many frames.
  void record_stopped(int frames) {
    (void)record(scene_, replacing(file_), stops_at(frames)).value();
  }
  // Without what lies behind its last frame.
  void cut_to_frames() {
    const std::string all = read_file(file_).value();
    const int frames = RecordingReader::open(file_)->frame_count();
    for (std::size_t size = all.size();; size -= 97) {
      ASSERT_TRUE(write_file(file_, std::string_view(all).substr(0, size)));
      if (RecordingReader::open(file_)->checkpoints().back() + 1U <
          static_cast<std::uint32_t>(frames))
        break;
    }
  }
  [[nodiscard]] std::string refusal(const RunLimit& limit = {}) const {
    return refusal_of(resume(file_, "test", goes_on, limit));
  }
  void expect_whole() {
    auto reader = RecordingReader::open(file_).value();
    EXPECT_TRUE(reader.finished());
    EXPECT_EQ(reader.ending(), RunEnding::duration);
    EXPECT_EQ(whole_.size(), 61U);
    EXPECT_EQ(frames_of(reader), whole_);
  }

  fs::path file_;
  Scene scene_;
  std::vector<PlayedFrame> whole_;
};

TEST_F(ResumeRun, a_stopped_run_goes_on_to_the_frames_of_one_that_never_stopped) {
  for (const int frames : {1, 2, 16, 17, 30, 60}) {
    record_stopped(frames);
    EXPECT_EQ(RecordingReader::open(file_)->frame_count(), frames);
    const auto statistics = resume(file_, "resumer", goes_on).value().value();
    EXPECT_EQ(statistics.frames, 61);
    EXPECT_EQ(statistics.frames_before, frames);
    EXPECT_EQ(statistics.steps, 240);
    expect_whole();
    const auto sessions = RecordingReader::open(file_)->sessions();
    ASSERT_EQ(sessions.size(), 1U);
    EXPECT_EQ(sessions[0].first_frame, static_cast<std::uint32_t>(frames));
    EXPECT_EQ(sessions[0].note, (SessionNote{SessionReason::resumed, "resumer", ""}));
  }
}

TEST_F(ResumeRun, checkpoints_are_at_the_start_at_multiples_of_their_interval_and_at_the_end) {
  const auto reader = RecordingReader::open(folder_ / "whole.rbn").value();
  // By hand: 30 frames/s, one each half second; the last frame is at 2 s.
  EXPECT_EQ(reader.checkpoints(), (std::vector<std::uint32_t>{0, 15, 30, 45, 60}));
  EXPECT_EQ(reader.read_checkpoint(15)->steps, 60U);
  scene_.recording.checkpoint_every_s = 0;
  record_stopped(20);
  EXPECT_EQ(RecordingReader::open(file_)->checkpoints(), (std::vector<std::uint32_t>{0, 19}));
}

TEST_F(ResumeRun, a_run_resumed_again_and_again_is_the_same) {
  record_stopped(3);
  for (const int frames : {7, 8, 20, 50})
    ASSERT_TRUE(resume(file_, "test", stops_at(frames)).has_value());
  ASSERT_TRUE(resume(file_, "test", goes_on).has_value());
  expect_whole();
  EXPECT_EQ(RecordingReader::open(file_)->sessions().size(), 5U);
}

TEST_F(ResumeRun, from_any_cut_tail_it_goes_on) {
  record_stopped(23);
  const std::string all = read_file(file_).value();
  // Each leaves another part of the last records, then of frames, then of checkpoints before.
  for (std::size_t bytes = 1; bytes < all.size() - 12000; bytes += 2611) {
    ASSERT_TRUE(write_file(file_, std::string_view(all).substr(0, all.size() - bytes)));
    ASSERT_EQ(refusal(), "") << bytes;
    expect_whole();
  }
}

TEST_F(ResumeRun, a_damaged_checkpoint_falls_back_to_the_one_before) {
  record_stopped(40);
  ASSERT_EQ(RecordingReader::open(file_)->checkpoints(),
            (std::vector<std::uint32_t>{0, 15, 30, 39}));
  const std::size_t in_the_last_state = fs::file_size(file_) - 1500;
  ASSERT_TRUE(write_file(file_, flipped(read_file(file_).value(), in_the_last_state)));
  ASSERT_FALSE(RecordingReader::open(file_)->read_checkpoint(39).has_value());
  int again = 0;
  const RunObserver observer{[](int, int, const FrameNumbers&) { return true; },
                             [&again](int, int total) {
                               again = total;
                               return true;
                             }};
  ASSERT_TRUE(resume(file_, "test", observer).has_value());
  EXPECT_EQ(again, 9) << "frames 31 to 39 from the checkpoint of frame 30";
  expect_whole();
}

// As ribbon-convert writes it.
TEST_F(ResumeRun, of_a_converted_recording_is_refused_as_such) {
  const auto written = [&](const RecordingHeader& header, std::size_t first, std::size_t step) {
    auto writer = RecordingWriter::create(file_, header).value();
    for (std::size_t frame = first; frame < 20; frame += step)
      (void)writer.append(*whole_[frame].numbers, whole_[frame].positions.cast<double>());
    return writer.finish().has_value();
  };
  const auto expect_refused = [&] {
    EXPECT_EQ(refusal(), file_.string() +
                             ": it was converted from another recording, with frames left out or "
                             "rounded again; go on with that one");
  };
  RecordingHeader header = RecordingReader::open(folder_ / "whole.rbn")->header();
  header.writer = "ribbon-convert 0.2.0";
  ASSERT_TRUE(written(header, 5, 1));
  expect_refused();
  header.frames_per_second /= 2;
  ASSERT_TRUE(written(header, 0, 2));
  expect_refused();
  header.frames_per_second *= 2;
  header.max_position_error_m *= 2;
  header.quantisation_step_m *= 2;
  ASSERT_TRUE(written(header, 0, 1));
  expect_refused();
  header.writer = "ribbon-record 0.1.0";
  ASSERT_TRUE(written(header, 5, 1));
  EXPECT_THAT(refusal(),
              testing::HasSubstr("go on with the program that recorded it, ribbon-record 0.1.0"));
}

// As the package for Python writes it.
TEST_F(ResumeRun, of_a_recording_without_a_scene_is_refused_as_such) {
  RecordingHeader header = RecordingReader::open(folder_ / "whole.rbn")->header();
  header.scene_text.clear();
  header.writer = "ribbon for Python 0.2.0";
  auto writer = RecordingWriter::create(file_, header).value();
  (void)writer.append(*whole_[0].numbers, whole_[0].positions.cast<double>());
  ASSERT_TRUE(writer.finish().has_value());
  EXPECT_EQ(refusal(), file_.string() +
                           ": it was written by ribbon for Python 0.2.0 and has no scene to go on "
                           "with; go on with a recording of ribbon-record");
}

// The writer alone, as if it had been killed before its first checkpoint.
TEST_F(ResumeRun, without_a_checkpoint_it_begins_at_the_start_again) {
  const auto header = RecordingReader::open(folder_ / "whole.rbn")->header();
  for (const int frames : {0, 1, 5}) {
    {
      auto writer = RecordingWriter::create(file_, header).value();
      for (int frame = 0; frame < frames; ++frame)
        ASSERT_TRUE(writer.append(*whole_[frame].numbers, whole_[frame].positions.cast<double>()));
    }
    ASSERT_EQ(refusal(), "") << frames;
    expect_whole();
  }
}

TEST_F(ResumeRun, a_drawing_that_is_gone_is_missed_only_without_a_checkpoint) {
  ASSERT_TRUE(write_file(folder_ / "knot.toml", drawn_in_a_file(scene_.text)));
  ASSERT_TRUE(write_file(folder_ / "line.svg", line_to("300")));
  scene_ = read_scene(folder_ / "knot.toml").value();
  record_stopped(5);
  fs::rename(folder_ / "line.svg", folder_ / "away.svg");
  EXPECT_EQ(refusal(), "");
  const auto header = RecordingReader::open(file_)->header();
  (void)RecordingWriter::create(file_, header)->take_place();
  EXPECT_THAT(refusal(), HasSubstr("no usable checkpoint, and the start cannot be made again"));
  ASSERT_TRUE(write_file(folder_ / "line.svg", line_to("310")));
  EXPECT_THAT(refusal(), HasSubstr("the drawing is not the one"));
  fs::rename(folder_ / "away.svg", folder_ / "line.svg");
  EXPECT_EQ(refusal(), "");
}

TEST_F(ResumeRun, a_width_read_off_an_outline_needs_the_drawing_no_more) {
  const fs::path outline = folder_ / "wedge.svg";
  ASSERT_TRUE(write_file(outline,
                         "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 -15 L900 -10 V10 "
                         "L0 15 Z'/></svg>"));
  std::string text = scene_.text;
  text.replace(text.find("width = 0.03"), 12, "outline = 'other.svg'");
  const std::vector<std::string> settings = {"ribbon.outline=wedge.svg"};
  const Scene scene = read_scene(folder_ / "knot.toml", text, settings).value();
  NewRecording recording = replacing(file_);
  recording.settings = settings;
  (void)record(scene, recording, stops_at(5)).value();
  fs::remove(outline);
  EXPECT_EQ(refusal(), "");
  const auto reader = RecordingReader::open(file_).value();
  EXPECT_TRUE(reader.finished());
  EXPECT_THAT(reader.header().scene_text, HasSubstr("\nwidth = [[0, "));
  EXPECT_NEAR(reader.header().row_widths_m.front(), 0.03, 1e-5);
  EXPECT_NEAR(reader.header().row_widths_m.back(), 0.02, 1e-5);
  EXPECT_EQ(refusal_of(branch(file_, 3, replacing(folder_ / "take.rbn"), goes_on)), "");
}

TEST_F(ResumeRun, a_finished_run_is_left_alone_unless_it_is_extended) {
  fs::copy_file(folder_ / "whole.rbn", file_);
  const std::string before = read_file(file_).value();
  const auto nothing = resume(file_, "test", goes_on).value();
  EXPECT_FALSE(nothing.has_value());
  EXPECT_TRUE(read_file(file_).value() == before);
}

TEST_F(ResumeRun, an_extended_run_is_as_one_that_was_longer_from_the_beginning) {
  std::string text = scene_.text;
  text.replace(text.find("duration = 2"), 12, "duration = 3");
  const Scene longer = read_scene(folder_ / "knot.toml", text).value();
  (void)record(longer, replacing(folder_ / "longer.rbn"), goes_on).value();
  whole_ = frames_of(folder_ / "longer.rbn");
  ASSERT_EQ(whole_.size(), 91U);
  for (const RunLimit& limit : {RunLimit{.until_s = 3}, RunLimit{.frames = 91}}) {
    fs::copy_file(folder_ / "whole.rbn", file_, fs::copy_options::overwrite_existing);
    ASSERT_EQ(refusal(limit), "");
    auto reader = RecordingReader::open(file_).value();
    EXPECT_EQ(reader.ending(), RunEnding::duration);
    EXPECT_EQ(frames_of(reader), whole_);
    ASSERT_EQ(reader.sessions().size(), 1U);
    EXPECT_EQ(reader.sessions()[0].note.reason, SessionReason::extended);
    EXPECT_EQ(reader.sessions()[0].note.changed_settings, "time.duration = 3\n");
  }
}

// The second resume knows from the file how far the run was to be extended.
TEST_F(ResumeRun, an_extension_that_was_stopped_goes_on_to_its_end) {
  fs::copy_file(folder_ / "whole.rbn", file_);
  ASSERT_TRUE(resume(file_, "test", stops_at(70), {.frames = 91}).has_value());
  EXPECT_EQ(RecordingReader::open(file_)->frame_count(), 70);
  ASSERT_TRUE(resume(file_, "test", goes_on).has_value());
  EXPECT_EQ(RecordingReader::open(file_)->frame_count(), 91);
  EXPECT_EQ(RecordingReader::open(file_)->ending(), RunEnding::duration);
}

TEST_F(ResumeRun, an_extension_from_before_the_first_frame_goes_on_to_its_end_as_well) {
  const auto header = RecordingReader::open(folder_ / "whole.rbn")->header();
  ASSERT_TRUE(RecordingWriter::create(file_, header)->take_place().has_value());
  ASSERT_TRUE(resume(file_, "test", stops_at(5), {.until_s = 3}).has_value());
  ASSERT_EQ(refusal(), "");
  const auto reader = RecordingReader::open(file_).value();
  EXPECT_EQ(reader.frame_count(), 91);
  ASSERT_EQ(reader.sessions().size(), 2U);
  EXPECT_EQ(reader.sessions()[0].first_frame, 0U);
  EXPECT_EQ(reader.sessions()[0].note.changed_settings, "time.duration = 3\n");
}

TEST_F(ResumeRun, a_limit_cuts_a_run_short_and_one_before_what_is_there_is_refused) {
  (void)record(scene_, replacing(file_), goes_on, {.frames = 20}).value();
  EXPECT_EQ(RecordingReader::open(file_)->ending(), RunEnding::limit);
  EXPECT_EQ(unfinished_text(*RecordingReader::open(file_)), "");
  EXPECT_EQ(RecordingReader::open(file_)->frame_count(), 20);
  EXPECT_THAT(refusal({.frames = 10}), HasSubstr("holds 20 frames already, more than the 10"));
  ASSERT_EQ(refusal({.until_s = 1}), "");
  EXPECT_EQ(RecordingReader::open(file_)->frame_count(), 31);
  EXPECT_EQ(RecordingReader::open(file_)->ending(), RunEnding::limit);
  ASSERT_EQ(refusal(), "");
  EXPECT_EQ(RecordingReader::open(file_)->ending(), RunEnding::duration);
  EXPECT_EQ(RecordingReader::open(file_)->sessions().back().note.reason, SessionReason::resumed);
  expect_whole();
}

class ResumeTight : public ResumeRun {
 protected:
  void SetUp() override {
    ResumeRun::SetUp();
    write_square_post(folder_);
    std::string text = small_scene_text() + "[obstacle]\nmesh = 'post.obj'\n";
    for (const std::string setting : {"time.duration=60", "time.until=tight", "fastening.speed=0.5",
                                      "fastening.yield=0.05", "recording.frames_per_second=10"})
      text = with_setting("", text, setting).value();
    scene_ = read_scene(folder_ / "knot.toml", text).value();
    frames_ = record(scene_, replacing(file_), goes_on).value().frames;
    whole_ = frames_of(file_);
    fs::remove(folder_ / "post.obj");  // the recording has it
  }

  int frames_ = 0;
};

TEST_F(ResumeTight, a_tight_knot_is_drawn_on_only_when_asked_to) {
  EXPECT_EQ(RecordingReader::open(file_)->ending(), RunEnding::tight);
  EXPECT_FALSE(resume(file_, "test", goes_on)->has_value());
  ASSERT_TRUE(resume(file_, "test", stops_at(frames_ + 2), {.frames = frames_ + 5}).has_value());
  EXPECT_EQ(RecordingReader::open(file_)->frame_count(), frames_ + 2);
  ASSERT_TRUE(resume(file_, "test", goes_on, {.frames = frames_ + 5}).has_value());
  const auto reader = RecordingReader::open(file_).value();
  EXPECT_EQ(reader.frame_count(), frames_ + 5);
  ASSERT_EQ(reader.sessions().size(), 2U);
  EXPECT_EQ(reader.sessions()[0].note.reason, SessionReason::extended);
  EXPECT_EQ(reader.sessions()[0].note.changed_settings, "time.until = \"duration\"\n");
  EXPECT_EQ(reader.sessions()[1].note.reason, SessionReason::resumed);
  EXPECT_EQ(first_difference(whole_, frames_of(file_)), -1);
}

TEST_F(ResumeTight, a_take_of_frames_before_it_was_drawn_on_ends_when_it_is_tight_itself) {
  ASSERT_EQ(refusal({.frames = frames_ + 5}), "");
  const fs::path take = folder_ / "take.rbn";
  for (const int frame : {0, frames_ / 2, frames_ - 2}) {
    ASSERT_TRUE(branch(file_, frame, replacing(take), goes_on).has_value());
    EXPECT_EQ(RecordingReader::open(take)->ending(), RunEnding::tight);
    EXPECT_EQ(frames_of(take), whole_) << frame;
  }
  const RunLimit limit{.frames = frames_ + 7};
  ASSERT_TRUE(branch(file_, frames_ + 2, replacing(take), goes_on, limit).has_value());
  EXPECT_EQ(RecordingReader::open(take)->frame_count(), frames_ + 7);
}

TEST_F(ResumeTight, killed_after_its_last_frame_it_only_needs_its_end) {
  cut_to_frames();
  const auto statistics = resume(file_, "test", goes_on).value();
  EXPECT_EQ(statistics->ending, RunEnding::tight);
  EXPECT_EQ(statistics->computed_steps, 0);
  const auto reader = RecordingReader::open(file_).value();
  EXPECT_EQ(reader.frame_count(), frames_);
  EXPECT_EQ(reader.ending(), RunEnding::tight);
  EXPECT_TRUE(reader.sessions().empty());
  EXPECT_EQ(reader.checkpoints().back(), static_cast<std::uint32_t>(frames_ - 1));
}

TEST_F(ResumeRun, a_new_run_may_be_longer_than_its_scene) {
  (void)record(scene_, replacing(file_), goes_on, {.until_s = 3}).value();
  const auto reader = RecordingReader::open(file_).value();
  EXPECT_EQ(reader.frame_count(), 91);
  EXPECT_THAT(reader.header().scene_text, HasSubstr("duration = 3\n"));
}

TEST_F(ResumeRun, what_comes_out_otherwise_than_recorded_is_told) {
  // The scene in the header is not the one that was simulated: its start is another already.
  auto header = RecordingReader::open(folder_ / "whole.rbn")->header();
  header.scene_text.replace(header.scene_text.find("stretch = 10"), 12, "stretch = 11");
  {
    auto writer = RecordingWriter::create(file_, header).value();
    for (int frame = 0; frame < 5; ++frame) {
      const auto& played = whole_[frame];
      ASSERT_TRUE(writer.append(*played.numbers, played.positions.cast<double>()));
    }
  }
  const std::string before = read_file(file_).value();
  EXPECT_THAT(refusal(), HasSubstr("knot.rbn: frame 1: simulated again, it comes out otherwise"));
  EXPECT_TRUE(read_file(file_).value() == before);
}

TEST_F(ResumeRun, given_up_while_it_is_simulated_again_it_leaves_all_as_it_was) {
  record_stopped(29);
  cut_to_frames();
  const std::string before = read_file(file_).value();
  const RunObserver gives_up{[](int, int, const FrameNumbers&) { return true; },
                             [](int done, int) { return done < 3; }};
  const auto statistics = resume(file_, "test", gives_up).value();
  EXPECT_EQ(statistics->ending, RunEnding::stopped);
  const std::string after = read_file(file_).value();
  EXPECT_TRUE(before.starts_with(after)) << "but for the torn tail";
  EXPECT_EQ(RecordingReader::open(file_)->frame_count(), 29);
  EXPECT_EQ(refusal(), "");
  expect_whole();
}

TEST_F(ResumeRun, what_is_no_recording_is_told_and_left_as_it_is) {
  ASSERT_TRUE(write_file(file_, "a letter"));
  EXPECT_THAT(refusal(), HasSubstr("knot.rbn"));
  EXPECT_EQ(read_file(file_).value(), "a letter");
  file_ = folder_ / "missing.rbn";
  EXPECT_THAT(refusal(), HasSubstr("missing.rbn"));
  EXPECT_FALSE(fs::exists(file_));
}

}  // namespace ribbon::resume_test

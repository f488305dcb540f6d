#include "converter/excerpt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "files/files.h"
#include "files/flipped.h"
#include "playback/recording_reader.h"
#include "recording/sample_recording.h"
#include "result/refusal.h"
#include "verification/frame_verifier.h"

namespace ribbon::excerpt_test {

class Excerpts : public TestInFolder {
 protected:
  Excerpts() { write_sample_recording(source_, 12); }

  Result<ConversionReport> write(const std::string& frames, double max_error_m = 0) {
    ConversionRequest request;
    request.recording = source_;
    request.output = target_;
    request.frames = frames;
    request.max_error_m = max_error_m;
    request.progress = ProgressStyle::none;
    request.force = true;
    return convert(request);
  }

  static Eigen::Matrix3Xf frame(RecordingReader& reader, int index) {
    Eigen::Matrix3Xf positions;
    EXPECT_TRUE(reader.read(index, positions));
    return positions;
  }

  std::filesystem::path source_ = folder_ / "source.rbn";
  std::filesystem::path target_ = folder_ / "target.rbn";
};

TEST_F(Excerpts, keep_their_frames_bit_for_bit) {
  ASSERT_EQ(write("3:11:4").value().frames_written, 3);
  auto source = RecordingReader::open(source_).value();
  auto target = RecordingReader::open(target_).value();
  ASSERT_EQ(target.frame_count(), 3);
  EXPECT_TRUE(target.finished());
  for (int kept = 0; kept < 3; ++kept) {
    EXPECT_EQ(frame(target, kept), frame(source, 2 + 4 * kept));
    EXPECT_EQ(target.numbers(kept), source.numbers(2 + 4 * kept));
  }
  EXPECT_EQ(target.header().stated_gap_m, source.header().stated_gap_m);
  EXPECT_EQ(target.header().frames_per_second, source.header().frames_per_second / 4);
}

TEST_F(Excerpts, of_frames_that_are_not_evenly_apart_keep_the_rate) {
  const double recorded = RecordingReader::open(source_).value().header().frames_per_second;
  for (const std::string frames : {"1,10,11,12", "1,2,5,12", "4"}) {
    ASSERT_TRUE(write(frames));
    EXPECT_EQ(RecordingReader::open(target_).value().header().frames_per_second, recorded);
  }
}

TEST_F(Excerpts, tell_how_many_frames_are_left_out_in_a_row) {
  EXPECT_EQ(write("").value().left_out, 0);
  EXPECT_EQ(write("5:9").value().left_out, 0);
  EXPECT_EQ(write("::3").value().left_out, 2);
  EXPECT_EQ(write("1,10,11,12").value().left_out, 8);
  EXPECT_EQ(write("1,2,5,12").value().left_out, 6);
}

TEST_F(Excerpts, of_a_recording_without_an_end_have_none_where_its_last_frame_is_kept) {
  write_sample_recording(source_, 12, Ending::killed);
  ASSERT_TRUE(write("5:"));
  const auto target = RecordingReader::open(target_).value();
  EXPECT_FALSE(target.finished());
  EXPECT_EQ(target.frame_count(), 8);
  ASSERT_TRUE(write(":5"));
  EXPECT_TRUE(RecordingReader::open(target_).value().finished());
}

TEST_F(Excerpts, tell_what_ended_the_run_only_where_its_last_frame_is_there) {
  std::uint64_t last = 0;
  {
    auto writer = RecordingWriter::create(source_, sample_header(), Overwrite::yes).value();
    append_sample_frames(writer, 0, 11);
    last = writer.bytes_written();
    append_sample_frames(writer, 11, 12);
    ASSERT_TRUE(writer.finish(RunEnding::tight));
  }
  ASSERT_TRUE(write("5:"));
  EXPECT_EQ(RecordingReader::open(target_)->ending(), RunEnding::tight);
  ASSERT_TRUE(write_file(source_, flipped(read_file(source_).value(), last + 30)));
  EXPECT_THAT(write("5:").value().missing, testing::ElementsAre(12));
  const auto target = RecordingReader::open(target_).value();
  EXPECT_TRUE(target.finished());
  EXPECT_EQ(target.ending(), RunEnding::unknown);
}

TEST_F(Excerpts, that_are_interrupted_may_be_tried_again) {
  ConversionRequest request;
  request.recording = source_;
  request.output = target_;
  request.progress = ProgressStyle::none;
  request.interrupted = [] { return true; };
  const auto written = convert(request);
  ASSERT_FALSE(written);
  EXPECT_TRUE(written.error().may_pass) << written.error().sentence();
}

TEST_F(Excerpts, do_not_take_the_place_of_a_recording_that_is_being_written) {
  {
    auto writer = RecordingWriter::create(target_, sample_header()).value();
    append_sample_frames(writer, 0, 1);
    EXPECT_THAT(refusal_of(write("")), HasSubstr("is being written by another program"));
    append_sample_frames(writer, 1, 2);
  }
  EXPECT_EQ(RecordingReader::open(target_).value().frame_count(), 2);
  EXPECT_TRUE(write(""));
}

TEST_F(Excerpts, are_other_recordings) {
  ASSERT_TRUE(write(""));
  EXPECT_NE(RecordingReader::open(source_).value().recording_id(),
            RecordingReader::open(target_).value().recording_id());
}

double smallest_gap_m(RecordingReader& reader) {
  const RecordingHeader& header = reader.header();
  const FrameVerifier verifier(rest_size(header), header.obstacle);
  double smallest_m = 1;
  Eigen::Matrix3Xf positions;
  for (int index = 0; index < reader.frame_count(); ++index)
    if (reader.read(index, positions))
      smallest_m = std::min(smallest_m, verifier.verify(positions).gap.certain_m);
  return smallest_m;
}

TEST_F(Excerpts, coarsened_ones_lose_no_more_of_the_gap_than_they_state) {
  auto source = RecordingReader::open(source_).value();
  const double added_m = 2e-5;
  const double before_m = source.header().max_position_error_m;
  ASSERT_TRUE(write("", before_m + added_m));
  auto target = RecordingReader::open(target_).value();
  EXPECT_LT(target.file_bytes(), source.file_bytes());
  EXPECT_DOUBLE_EQ(target.header().max_position_error_m, before_m + added_m);
  const double lost_m = source.header().stated_gap_m - target.header().stated_gap_m;
  EXPECT_NEAR(lost_m, 2 * std::sqrt(3) * added_m, 1e-12);
  EXPECT_GE(smallest_gap_m(target), smallest_gap_m(source) - lost_m);
  const double shortest_m = rest_size(source.header()).shortest_edge_m();
  EXPECT_NEAR(target.header().strain_limit - source.header().strain_limit, lost_m / shortest_m,
              1e-12);
  float largest = 0;
  for (int index = 0; index < 12; ++index)
    largest =
        std::max(largest, (frame(target, index) - frame(source, index)).cwiseAbs().maxCoeff());
  EXPECT_LE(largest, added_m);
  EXPECT_GT(largest, added_m / 2);
}

TEST_F(Excerpts, a_coarsening_that_closes_the_gap_is_refused_with_the_limit) {
  const double before_m = RecordingReader::open(source_).value().header().max_position_error_m;
  const double limit_m = before_m + 1e-4 / (2 * std::sqrt(3));
  EXPECT_THAT(refusal_of(write("", 1.001 * limit_m)), HasSubstr("layers could meet"));
  EXPECT_TRUE(write("", 0.999 * limit_m));
  for (const double error_m : {before_m / 2, before_m})
    EXPECT_THAT(refusal_of(write("", error_m)), HasSubstr("leave --max-error out"));
  RecordingReader source = RecordingReader::open(source_).value();
  RecordingHeader header = source.header();
  header.stated_gap_m = before_m / 1000;
  const std::vector<Eigen::Matrix3Xd> frames{frame(source, 0).cast<double>()};
  write_recording(source_, header, frames);
  EXPECT_THAT(refusal_of(write("", 2 * before_m)),
              AllOf(HasSubstr("layers could meet"), EndsWith("; leave --max-error out")))
      << "what would do is told in too few digits";
}

TEST_F(Excerpts, of_a_recording_without_loss_are_as_far_off_as_single_precision_to_begin_with) {
  auto recorded = RecordingReader::open(source_).value();
  RecordingHeader header = recorded.header();
  header.max_position_error_m = 0;
  header.quantisation_step_m = 0;
  std::vector<Eigen::Matrix3Xd> frames(12);
  for (int index = 0; index < 12; ++index)
    frames[index] = frame(recorded, index).cast<double>().array() + 3;
  std::filesystem::remove(source_);
  write_recording(source_, header, frames);
  // Half of what lies between the numbers from 2 to 4.
  constexpr double single_m = 0x1p-23;
  EXPECT_THAT(refusal_of(write("", 0.99 * single_m)),
              HasSubstr("so they cannot come to be within 1.18e-07 m; leave --max-error out"));
  ASSERT_TRUE(write("", 1e-6));
  EXPECT_LE(RecordingReader::open(target_).value().header().quantisation_step_m,
            2 * (1e-6 - single_m));
}

TEST_F(Excerpts, leave_nothing_behind_where_they_fail) {
  EXPECT_THAT(refusal_of(write("5:2:-1")), HasSubstr("forwards"));
  EXPECT_FALSE(std::filesystem::exists(target_));
  EXPECT_FALSE(write("", 1));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_),
                          std::filesystem::directory_iterator()),
            1);
}

TEST_F(Excerpts, what_a_recording_does_not_hold_is_refused) {
  ConversionRequest request;
  request.recording = source_;
  request.output = target_;
  request.model.placement.up = UpAxis::z;
  EXPECT_THAT(refusal_of(convert(request)), HasSubstr("--up"));
}

}  // namespace ribbon::excerpt_test

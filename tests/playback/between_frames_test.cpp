#include "playback/between_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "files/files.h"
#include "files/flipped.h"
#include "recording/sample_recording.h"
#include "result/refusal.h"

namespace ribbon::between_frames_test {

constexpr RibbonGrid grid{8, 4};

// One coordinate of every particle is a polynomial of the frame's number.
double height(double frame) {
  return 0.2 + 0.01 * frame - 0.003 * frame * frame;
}

class BetweenTheFrames : public TestInFolder {
 protected:
  // A recording of `frames` frames whose particles rise along height().
  RecordingReader risen(int frames) {
    RecordingHeader header = sample_header(grid);
    std::vector<Eigen::Matrix3Xd> positions;
    for (int f = 0; f < frames; ++f) {
      Eigen::Matrix3Xd frame = Eigen::Matrix3Xd::Zero(3, grid.particle_count());
      for (int p = 0; p < grid.particle_count(); ++p) frame(0, p) = 0.01 * p;
      frame.row(1).setConstant(height(f));
      positions.push_back(frame);
    }
    write_recording(path_, header, positions, Ending::finished);
    return RecordingReader::open(path_).value();
  }

  const std::filesystem::path path_ = folder_ / "risen.rbn";
};

double read_height(BetweenFrames& between, int index, double after) {
  Eigen::Matrix3Xf positions;
  EXPECT_TRUE(between.read(index, after, positions));
  return positions.row(1).mean();
}

TEST_F(BetweenTheFrames, a_frame_is_what_was_recorded_bit_for_bit) {
  RecordingReader reader = risen(6);
  BetweenFrames between(reader);
  for (const int index : {0, 3, 5}) {
    Eigen::Matrix3Xf frame;
    Eigen::Matrix3Xf read;
    ASSERT_TRUE(reader.read(index, frame));
    ASSERT_TRUE(between.read(index, 0, read));
    EXPECT_EQ(read, frame) << index;
  }
}

TEST_F(BetweenTheFrames, an_even_acceleration_is_followed_exactly_where_there_are_neighbours) {
  RecordingReader reader = risen(6);
  BetweenFrames between(reader);
  for (const int index : {1, 2, 3})
    for (const double after : {0.1, 0.5, 0.8})
      EXPECT_NEAR(read_height(between, index, after), height(index + after), 3e-5)
          << index << " " << after;
}

TEST_F(BetweenTheFrames, beside_a_lost_frame_it_is_as_at_an_end) {
  RecordingReader whole = risen(12);
  BetweenFrames undamaged(whole);
  const std::string bytes = read_file(path_).value();
  std::filesystem::remove(path_);
  ASSERT_TRUE(write_file(path_, flipped(bytes, bytes.size() / 2)));
  RecordingReader reader = RecordingReader::open(path_).value();
  reader.check();
  int lost = 0;
  while (reader.readable(lost)) ++lost;
  ASSERT_GE(lost, 2);
  ASSERT_LT(lost, 12);
  BetweenFrames between(reader);
  const double height_m = read_height(between, lost - 2, 0.3);
  EXPECT_GT(std::abs(height_m - read_height(undamaged, lost - 2, 0.3)), 1e-5);
  std::filesystem::remove(path_);
  RecordingReader shorter = risen(lost);
  BetweenFrames at_end(shorter);
  EXPECT_NEAR(height_m, read_height(at_end, lost - 2, 0.3), 1e-7);
}

TEST_F(BetweenTheFrames, of_two_frames_the_way_is_straight) {
  RecordingReader reader = risen(2);
  BetweenFrames between(reader);
  EXPECT_NEAR(read_height(between, 0, 0.25), 0.75 * height(0) + 0.25 * height(1), 3e-5);
}

TEST_F(BetweenTheFrames, what_was_read_before_makes_no_difference) {
  RecordingReader reader = risen(12);
  BetweenFrames jumping(reader);
  for (const int index : {7, 2, 9, 3, 8, 0}) {
    BetweenFrames fresh(reader);
    EXPECT_EQ(read_height(jumping, index, 0.3), read_height(fresh, index, 0.3)) << index;
  }
}

TEST_F(BetweenTheFrames, two_frames_of_which_one_is_lost_have_nothing_between_them) {
  (void)risen(12);
  ASSERT_TRUE(
      write_file(path_, flipped(read_file(path_).value(), std::filesystem::file_size(path_) / 2)));
  RecordingReader reader = RecordingReader::open(path_).value();
  reader.check();
  BetweenFrames between(reader);
  Eigen::Matrix3Xf positions;
  int lost = 0;
  for (int index = 0; index + 1 < reader.frame_count(); ++index) {
    const bool both = reader.readable(index) && reader.readable(index + 1);
    EXPECT_EQ(between.read(index, 0.5, positions).has_value(), both) << index;
    lost += both ? 0 : 1;
  }
  EXPECT_GT(lost, 0);
  EXPECT_LT(lost, 11);
}

}  // namespace ribbon::between_frames_test

#include "soak/strained_springs.h"

#include <gtest/gtest.h>

#include "recording/sample_recording.h"

namespace ribbon::strained_springs_test {

// Two squares of 1 m side by side: 4 springs along, 3 across and 4 diagonal ones.
Eigen::Matrix3Xd two_squares(double along_m) {
  Eigen::Matrix3Xd positions(3, 6);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) positions.col(2 * i + j) << along_m * i, j, 0;
  return positions;
}

StrainedSprings strained(const std::vector<Eigen::Matrix3Xd>& frames) {
  RecordingHeader header = sample_header();
  header.grid = {3, 2};
  header.uv = Eigen::Matrix2Xf::Zero(2, 6);
  header.ribbon_length_m = 2;
  header.ribbon_width_m = 1;
  const auto file = temporary_file("squares.rbn");
  write_recording(file, header, frames);
  auto recording = RecordingReader::open(file).value();
  return strained_springs(recording, 0.1).value();
}

TEST(StrainedSprings, are_none_in_the_flat_ribbon) {
  const StrainedSprings flat = strained({two_squares(1)});
  EXPECT_EQ(flat.springs, 11U);
  EXPECT_EQ(flat.worst_share, 0);
  EXPECT_NEAR(flat.worst_elongation, 0, 1e-4);
}

// 1.2 m instead of 1 stretches what runs along by 20 %, and the diagonals from 1.414 m to 1.562 m,
// by 10.5 %; what runs across stays.
TEST(StrainedSprings, are_counted_in_the_worst_frame_on_average_and_at_the_end) {
  const StrainedSprings springs =
      strained({two_squares(1), two_squares(1.2), two_squares(1.2), two_squares(1.05)});
  EXPECT_DOUBLE_EQ(springs.worst_share, 8.0 / 11);
  EXPECT_EQ(springs.worst_share_frame, 2);
  EXPECT_DOUBLE_EQ(springs.mean_share, 4.0 / 11);
  EXPECT_EQ(springs.last_share, 0);
  EXPECT_NEAR(springs.worst_elongation, 0.2, 1e-3);
}

TEST(StrainedSprings, count_when_they_are_shrunk) {
  const StrainedSprings springs = strained({two_squares(0.7)});
  EXPECT_GT(springs.worst_share, 0);
  EXPECT_NEAR(springs.worst_elongation, 0.3, 1e-3);
}

}  // namespace ribbon::strained_springs_test

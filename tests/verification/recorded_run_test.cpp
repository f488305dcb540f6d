// Both oracles on what is really recorded, as it is and bent out of shape.
#include <gtest/gtest.h>

#include "playback/recording_reader.h"
#include "recorder/record.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"
#include "recording/sample_recording.h"
#include "scene/scene.h"
#include "verification/cgal_oracle.h"
#include "verification/frame_verifier.h"

namespace ribbon::recorded_run_test {

class RecordedRun : public testing::Test {
 protected:
  static RecordingReader record_run() {
    const auto path = temporary_file("run.rbn");
    const Scene scene = read_scene(write_small_scene(path.parent_path())).value();
    (void)record(scene, replacing(path), goes_on).value();
    return RecordingReader::open(path).value();
  }

  Eigen::Matrix3Xf frame(int index) {
    Eigen::Matrix3Xf positions;
    EXPECT_TRUE(reader_.read(index, positions).has_value());
    return positions;
  }

  // How many pairs intersect in the opinion of all.
  std::size_t agreed_pairs(const Eigen::Matrix3Xf& positions) {
    const auto pairs = verifier_.verify(positions).intersections.pairs;
    EXPECT_EQ(pairs, cgal_intersecting_pairs(verifier_.soup(positions)));
    const auto meshed = cgal_self_intersections(reader_.header().grid, positions);
    EXPECT_TRUE(!meshed || *meshed == pairs);
    return pairs.size();
  }

  RecordingReader reader_ = record_run();
  FrameVerifier verifier_{rest_size(reader_.header()), reader_.header().obstacle};
};

TEST_F(RecordedRun, all_oracles_find_it_free_of_intersections) {
  ASSERT_EQ(reader_.frame_count(), 7);
  for (int index = 0; index < reader_.frame_count(); ++index)
    EXPECT_EQ(agreed_pairs(frame(index)), 0U) << "frame " << index + 1;
}

TEST_F(RecordedRun, all_oracles_find_the_same_pairs_when_it_is_pressed_flat) {
  Eigen::Matrix3Xf pressed = frame(6);
  pressed.row(1).setZero();
  EXPECT_GT(agreed_pairs(pressed), 0U);
}

TEST_F(RecordedRun, all_oracles_find_the_same_pairs_when_one_half_moves_through_the_other) {
  std::size_t pairs = 0;
  for (int step = -10; step <= 10; ++step) {
    Eigen::Matrix3Xf moved = frame(6);
    moved.row(1).head(moved.cols() / 2).array() += 0.01F * static_cast<float>(step);
    pairs += agreed_pairs(moved);
  }
  EXPECT_GT(pairs, 0U);
}

TEST_F(RecordedRun, all_oracles_find_the_same_pairs_when_particles_are_swapped) {
  const RibbonGrid grid = reader_.header().grid;
  // Not at the free end, where cloth lies in one plane and rounding alone would tell.
  for (int row = 5; row <= 45; row += 5) {
    Eigen::Matrix3Xf swapped = frame(3);
    swapped.col(grid.particle(row, 1)).swap(swapped.col(grid.particle(row + 1, 1)));
    EXPECT_GT(agreed_pairs(swapped), 0U) << "row " << row;
  }
}

}  // namespace ribbon::recorded_run_test

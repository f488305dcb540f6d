// ribbon-play beside a recorder.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "player/ribbon_play.h"
#include "recording/sample_recording.h"
#include "recording/writer/recording_writer.h"

namespace ribbon::follow_test {

// The sample's ribbon, straight but for a loop that wanders along it.
Eigen::Matrix3Xd looped(int frame) {
  const RecordingHeader header = sample_header();
  const RibbonGrid& grid = header.grid;
  const double begin = 0.1 + 0.004 * frame;
  constexpr double radius = 0.08;
  constexpr double round = 2 * std::numbers::pi * radius;
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int i = 0; i < grid.along; ++i) {
    const double s = header.ribbon_length_m * i / (grid.along - 1);
    const double angle = std::clamp((s - begin) / radius, 0.0, 2 * std::numbers::pi);
    const double straight = std::min(s, begin) + std::max(s - begin - round, 0.0);
    for (int j = 0; j < grid.across; ++j)
      positions.col(grid.particle(i, j)) << straight - 0.3 + radius * std::sin(angle),
          header.ribbon_width_m * j / (grid.across - 1),
          radius * (1 - std::cos(angle)) + 0.02 * angle;
  }
  return positions;
}

TEST_F(RibbonPlay, a_camera_that_follows_the_knot_of_a_growing_recording_takes_the_later_pictures) {
  constexpr int frames = 60;
  RecordingHeader header = sample_header();
  header.obstacle.reset();
  auto writer = RecordingWriter::create(recording_, header).value();
  const auto append = [&](int frame) {
    ASSERT_TRUE(writer.append(sample_numbers(frame), looped(frame)));
  };
  append(0);
  const std::string view = " --view knot";
  ToolRun followed;
  std::thread follower([&] { followed = play_small("-o 'live/{frame:02}.png' --follow" + view); });
  for (int frame = 1; frame < frames; ++frame) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    append(frame);
  }
  ASSERT_TRUE(writer.finish());
  follower.join();
  EXPECT_EQ(followed.exit_code, 0) << followed.errors;
  ASSERT_EQ(play_small("-o 'later/{frame:02}.png'" + view).exit_code, 0);
  ASSERT_EQ(pictures("live").size(), 60U);
  for (const std::string& name : pictures("later"))
    EXPECT_TRUE(bytes("live/" + name) == bytes("later/" + name)) << name;
}

}  // namespace ribbon::follow_test

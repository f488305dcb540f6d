#include "recorder/run/simulated_frames.h"

#include <gtest/gtest.h>

#include <string>

#include "recorder/small_scene.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"

namespace ribbon::simulated_frames_test {

// Four steps to a frame, and hands that draw the loop through itself if nothing stops them.
Scene fast_scene(const std::string& contact) {
  std::string text = "contact = '" + contact + "'\n" + small_scene_text("1");
  text.replace(text.find("speed = 0.2"), 11, "speed = 16\nyield = 'never'");
  text.replace(text.find("frames_per_second = 30"), 22, "frames_per_second = 25");
  return read_scene("small.toml", text).value();
}

FasteningProcessor fastening_of(const Scene& scene) {
  return FasteningProcessor::create(scene, draw_ribbon(scene).value(), std::nullopt).value();
}

struct Steps {
  int recovery_iterations = 0;
  int penetrating_edges = 0;  // after the last one
  double truncated = 0;
  double pull = 0;
};

Steps four_steps(FasteningProcessor& fastening) {
  Steps steps;
  for (int k = 0; k < 4; ++k) {
    const StepReport report = fastening.step();
    steps.recovery_iterations += report.recovery_iterations;
    steps.penetrating_edges = report.penetrating_edges;
    steps.truncated += report.truncated;
    steps.pull += report.pull;
  }
  return steps;
}

class NumbersOfFrames : public testing::TestWithParam<std::string> {};

TEST_P(NumbersOfFrames, are_those_of_all_steps_since_the_last_one) {
  const Scene scene = fast_scene(GetParam());
  FasteningProcessor by_steps = fastening_of(scene);
  SimulatedFrames frames(scene, fastening_of(scene), -1);
  const FrameNumbers first = frames.next().numbers;
  EXPECT_EQ(first.tightness->truncated, 0);
  EXPECT_EQ(first.tightness->pull, 1);
  const double particles = scene.ribbon.along * scene.ribbon.across;
  Steps all;
  for (int frame = 1; frame <= 5; ++frame) {
    const Steps steps = four_steps(by_steps);
    const SimulatedFrame taken = frames.next();
    ASSERT_EQ(taken.positions, by_steps.positions()) << frame;
    EXPECT_EQ(taken.numbers.recovery_iterations, steps.recovery_iterations) << frame;
    EXPECT_EQ(taken.numbers.penetrating_edges, steps.penetrating_edges) << frame;
    EXPECT_NEAR(taken.numbers.tightness->truncated, steps.truncated / 4 / particles, 1e-7) << frame;
    EXPECT_NEAR(taken.numbers.tightness->pull, steps.pull / 4, 1e-7) << frame;
    all.recovery_iterations += steps.recovery_iterations;
    all.truncated += steps.truncated;
  }
  EXPECT_EQ(all.recovery_iterations > 0, GetParam() == "paper");
  EXPECT_EQ(all.truncated > 0, GetParam() == "gate");
}

INSTANTIATE_TEST_SUITE_P(Contact, NumbersOfFrames, testing::Values("gate", "paper"));

}  // namespace ribbon::simulated_frames_test

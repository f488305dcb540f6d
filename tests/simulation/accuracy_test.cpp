#include "scene/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "simulation/fastening_processor.h"
#include "simulation/frame_judge.h"
#include "simulation/loop_scene.h"

namespace ribbon::accuracy_test {

using Eigen::Matrix3Xd;

// A band that touches nothing: the ends of the arc stay far apart.
SpaceCurve arc(int samples) {
  SpaceCurve curve;
  curve.points.resize(3, samples);
  for (int i = 0; i < samples; ++i) {
    const double angle = 1.6 * std::numbers::pi * (static_cast<double>(i) / (samples - 1) - 0.5);
    curve.points.col(i) << 0.9 * std::sin(angle), 0, -0.9 * std::cos(angle);
  }
  curve.length_m = 0.9 * 1.6 * std::numbers::pi;
  return curve;
}

Matrix3Xd pulled_for_half_a_second(const AccuracyLevel& level) {
  Scene scene = scene_of_loop();
  scene.ribbon.along = 60;
  scene.ribbon.across = 3;
  scene.springs = {.stretch = 50, .shear = 50, .bend = 50};  // k/m as in the samples
  set_accuracy(level, scene);
  const RibbonMesh mesh = generate_ribbon_mesh(arc(60), scene.ribbon, Axis::y);
  auto fastening = FasteningProcessor::create(scene, mesh, std::nullopt).value();
  while (fastening.time_s() < 0.5 - 1e-9) fastening.step();
  return fastening.positions();
}

TEST(Accuracy, each_level_comes_nearer_to_the_converged_motion) {
  AccuracyLevel converged = accuracy_levels.back();
  converged.step_s /= 4;
  const Matrix3Xd truth = pulled_for_half_a_second(converged);
  double last_m = std::numeric_limits<double>::infinity();
  for (const AccuracyLevel& level : accuracy_levels) {
    const double away_m = (pulled_for_half_a_second(level) - truth).norm();
    EXPECT_LT(away_m, 0.7 * last_m) << level.word;
    EXPECT_GT(away_m, 0) << level.word;
    last_m = away_m;
  }
}

// Hands that do not yield pull the loop on its post, and over itself.
TEST(Accuracy, no_level_lets_the_ribbon_intersect) {
  for (const AccuracyLevel& level : accuracy_levels) {
    Scene scene = scene_of_loop();
    scene.fastening->speed_m_s = 2;
    set_accuracy(level, scene);
    const RibbonMesh mesh = mesh_of_loop(scene);
    auto fastening = FasteningProcessor::create(scene, mesh, post(0.3)).value();
    const FrameJudge judge(mesh, post(0.3));
    for (int frame = 0; frame < 10; ++frame) {
      while (fastening.time_s() < 0.04 * (frame + 1) - 1e-9) fastening.step();
      ASSERT_TRUE(judge.is_free(fastening.positions())) << level.word << " " << frame;
    }
  }
}

}  // namespace ribbon::accuracy_test

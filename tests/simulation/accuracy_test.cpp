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

// The end of a band of half a metre over 0.3 m, sideways, at 0.3 m/s.
TEST(Accuracy, a_hand_carries_in_the_same_time_at_any_step) {
  Scene scene;
  scene.ribbon = {.width_m = 0.02, .along = 100, .across = 4, .mass_kg = 0.02};
  scene.springs = {.stretch = 300, .shear = 100, .bend = 20};
  scene.air_resistance_per_s = 20;
  scene.fastening = FasteningScene{.speed_m_s = 0.3};
  scene.curve.unit_m = 1;
  HandScene hand{.at = Span{0.98, 1}, .task = HandTask::carry, .speed_m_s = 0.3};
  hand.carry = {std::vector<Eigen::Vector2d>{{0.5, 0}, {0.5, 0.3}}, {{0, 0}, {1, 0}}};
  scene.stages = {{.hands = {hand}, .goal = StageGoal::carried}};
  const RibbonMesh mesh =
      generate_ribbon_mesh(straight_curve(scene.ribbon.along, 0.5), scene.ribbon, Axis::y);
  const auto carried_after_s = [&](double step_s) {
    scene.time = {.step_s = step_s, .duration_s = 5};
    auto fastening = FasteningProcessor::create(scene, mesh, std::nullopt).value();
    while (!fastening.stages_are_over() && fastening.time_s() < 4) fastening.step();
    return fastening.time_s();
  };
  const double published_s = carried_after_s(0.01);
  EXPECT_LT(published_s, 1.2);
  for (const double step_s : {0.02, 0.005, 0.00125})
    EXPECT_NEAR(carried_after_s(step_s), published_s, 0.03) << step_s;
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

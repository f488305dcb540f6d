// Ribbons that have weight: what holds them, and how they answer.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "simulation/fastening_processor.h"
#include "simulation/frame_judge.h"
#include "simulation/loop_scene.h"
#include "simulation/state/edge_strain.h"

namespace ribbon::gravity_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double earths = 9.81;
constexpr double post_radius_m = 0.2;

// A band of 2 m of cloth that bears its own weight, level, 10 cm above a post that lies along y.
Scene scene_of_drape(ContactMethod contact = ContactMethod::gate) {
  Scene scene;
  scene.name = "drape";
  scene.contact = contact;
  scene.ribbon = {.width_m = 0.06, .along = 61, .across = 4, .mass_kg = 0.03};
  scene.springs = {.stretch = 10, .shear = 10, .bend = 1};
  scene.air_resistance_per_s = 8;
  scene.gravity_m_s2 = Vector3d(0, 0, -earths);
  scene.friction = 0.3;
  scene.time = {.step_s = 0.01, .duration_s = 10};
  return scene;
}

RibbonMesh level_ribbon(const Scene& scene) {
  return generate_ribbon_mesh(straight_curve(scene.ribbon.along, 2, {-1, 0, post_radius_m + 0.1}),
                              scene.ribbon, Axis::y);
}

FasteningProcessor above_the_post(const Scene& scene) {
  return FasteningProcessor::create(scene, level_ribbon(scene), post(post_radius_m)).value();
}

double height_of_row_m(const Scene& scene, const Matrix3Xd& positions, int row) {
  return positions.row(2)
      .segment(Eigen::Index{row} * scene.ribbon.across, scene.ribbon.across)
      .mean();
}

void expect_draped(const Scene& scene, const Matrix3Xd& positions) {
  EXPECT_NEAR(height_of_row_m(scene, positions, 30), post_radius_m, 0.02);
  EXPECT_LT(height_of_row_m(scene, positions, 0), -0.3);
  EXPECT_LT(height_of_row_m(scene, positions, 60), -0.3);
}

TEST(Gravity, a_ribbon_that_falls_on_a_post_drapes_over_it_and_stays_certified) {
  for (const IntegrationMethod method :
       {IntegrationMethod::rk4, IntegrationMethod::symplectic_euler, IntegrationMethod::implicit}) {
    SCOPED_TRACE(static_cast<int>(method));
    Scene scene = scene_of_drape();
    scene.time.integrator = method;
    FasteningProcessor processor = above_the_post(scene);
    const FrameJudge judge(level_ribbon(scene), post(post_radius_m));
    for (int step = 0; step < 300; ++step) {
      processor.step();
      ASSERT_TRUE(judge.is_free(processor.positions())) << step;
      ASSERT_LE(processor.strain(), paper_strain_limit) << step;
    }
    expect_draped(scene, processor.positions());
  }
}

TEST(Gravity, as_published_a_ribbon_drapes_over_a_post_too) {
  const Scene scene = scene_of_drape(ContactMethod::paper);
  FasteningProcessor processor = above_the_post(scene);
  for (int step = 0; step < 300; ++step) processor.step();
  expect_draped(scene, processor.positions());
}

TEST(Gravity, what_nothing_holds_falls_as_fast_as_air_lets_it) {
  const Scene scene = scene_of_drape();
  auto processor = FasteningProcessor::create(scene, level_ribbon(scene), std::nullopt).value();
  for (int step = 0; step < 200; ++step) processor.step();
  const Matrix3Xd before = processor.positions();
  processor.step();
  const Matrix3Xd fallen = processor.positions() - before;
  EXPECT_LT((fallen.colwise() - Vector3d(0, 0, -0.01 * earths / 8)).cwiseAbs().maxCoeff(), 1e-6);
}

// By hand: backward Euler's n steps of h seconds fall n (n + 1) / 2 times g h^2. Weight alone
// brings four edges a step, and in the end all go 800 at a time.
TEST(Gravity, a_fine_mesh_falls_as_far_as_it_should_in_long_steps) {
  Scene scene = scene_of_drape();
  scene.ribbon = {.width_m = 0.002, .along = 30, .across = 3, .mass_kg = 0.001};
  scene.air_resistance_per_s = 0;
  scene.time.integrator = IntegrationMethod::implicit;
  scene.time.step_s = 0.02;
  const RibbonMesh ribbon =
      generate_ribbon_mesh(straight_curve(scene.ribbon.along, 0.029), scene.ribbon, Axis::y);
  auto processor = FasteningProcessor::create(scene, ribbon, std::nullopt).value();
  const Matrix3Xd before = processor.positions();
  for (int step = 0; step < 200; ++step) processor.step();
  const Matrix3Xd fallen = processor.positions() - before;
  EXPECT_NEAR(fallen.row(2).mean(), -20100 * earths * 0.02 * 0.02, 1e-4);
}

// By hand: between two hands that are L apart a band of weight w per length, whose springs bear EA
// times their strain, hangs as a parabola of sag d, with d^3 = 3 w L^4 / 64 EA (what is L long when
// nothing strains it is so short that 8 d^2 / 3 L is its stretch, and bears w L^2 / 8 d).
TEST(Gravity, what_hangs_between_two_hands_sags_as_much_as_its_stretch_lets_it_at_any_step) {
  constexpr double k = 60;
  for (const IntegrationMethod method :
       {IntegrationMethod::symplectic_euler, IntegrationMethod::implicit})
    for (const double step_s : {0.02, 0.005}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(method) << ", step " << step_s);
      Scene scene = scene_of_drape();
      scene.springs = {.stretch = k, .damping = 1};
      scene.time.integrator = method;
      scene.time.step_s = step_s;
      scene.fastening = FasteningScene{.speed_m_s = 50};
      const auto holding = [](double begin, double end) {
        return HandScene{.at = Span{begin, end}, .task = HandTask::hold, .speed_m_s = 50};
      };
      scene.stages = {{.until_s = 9, .hands = {holding(0, 0.05), holding(0.95, 1)}}};
      auto processor = FasteningProcessor::create(scene, level_ribbon(scene), std::nullopt).value();
      const Matrix3Xd begun = processor.positions();
      for (int step = 0; step < 5 / step_s; ++step) processor.step();
      const Matrix3Xd hung = processor.positions();
      const Eigen::Index held = 4 * Eigen::Index{scene.ribbon.across};  // particles, at each end
      EXPECT_LT((hung - begun).leftCols(held).colwise().norm().maxCoeff(), 1e-3);
      EXPECT_LT((hung - begun).rightCols(held).colwise().norm().maxCoeff(), 1e-3);
      const double spacing_m = 2.0 / (scene.ribbon.along - 1);
      const double apart_m = 2 - 2 * 3 * spacing_m;
      const double newton_per_m = scene.ribbon.mass_kg * earths / 2;
      const double stiffness_n = scene.ribbon.across * k * spacing_m;
      const double sag_m = std::cbrt(3 * newton_per_m * std::pow(apart_m, 4) / (64 * stiffness_n));
      EXPECT_NEAR(-height_of_row_m(scene, hung - begun, 30), sag_m, 0.02 * sag_m);
    }
}

TEST(Gravity, begins_and_ends_with_the_stages_that_have_it) {
  Scene scene = scene_of_drape();
  scene.fastening = FasteningScene{.speed_m_s = 0.1};
  const HandScene hand{
      .at = Span{0.5, 0.5}, .task = HandTask::pull, .direction = {0, 1, 0}, .speed_m_s = 1e-6};
  scene.stages = {
      {.until_s = 0.5, .gravity_m_s2 = Vector3d(0, 0, 0), .hands = {hand}},
      {.until_s = 2, .gravity_m_s2 = Vector3d(2 * earths, 0, 0), .hands = {hand}},
      {.until_s = 2, .hands = {hand}},
  };
  auto processor = FasteningProcessor::create(scene, level_ribbon(scene), std::nullopt).value();
  const auto gone_after = [&](int steps) -> Vector3d {
    const Matrix3Xd before = processor.positions();
    for (int step = 0; step < steps; ++step) processor.step();
    return (processor.positions() - before).rowwise().mean();
  };
  EXPECT_LT(gone_after(50).norm(), 1e-6);
  (void)gone_after(199);
  const double fast_m = 0.01 * 2 * earths / 8;
  EXPECT_TRUE(gone_after(1).isApprox(Vector3d(fast_m, 0, 0), 1e-3)) << "as fast as air lets it";
  (void)gone_after(249);
  EXPECT_TRUE(gone_after(1).isApprox(Vector3d(0, 0, -fast_m / 2), 1e-3)) << "also when all is over";
}

// Cloth a hundred times too heavy: its strain stays within the limit, and it sinks all the same.
TEST(Gravity, cloth_that_cannot_bear_its_weight_does_not_stay_in_the_air) {
  Scene scene = scene_of_drape();
  scene.ribbon.mass_kg *= 100;
  FasteningProcessor processor = above_the_post(scene);
  for (int step = 0; step < 300; ++step) {
    processor.step();
    ASSERT_LE(processor.strain(), paper_strain_limit) << step;
  }
  EXPECT_LT(height_of_row_m(scene, processor.positions(), 0), 0);
  EXPECT_LT(height_of_row_m(scene, processor.positions(), 60), 0);
}

// The loop that the ribbon is laid in hangs on the post; its ends swing down and are drawn.
TEST(Gravity, a_loop_that_hangs_on_a_post_is_drawn_tight_and_knows_that_it_is) {
  Scene scene = scene_of_loop();
  scene.ribbon.mass_kg = 0.05;
  scene.air_resistance_per_s = 10;
  scene.gravity_m_s2 = Vector3d(0, 0, earths);
  scene.fastening->speed_m_s = 0.7;
  scene.fastening->yield_strain = 0.03;
  FasteningProcessor processor =
      FasteningProcessor::create(scene, mesh_of_loop(scene), post(0.3)).value();
  int steps = 0;
  StepReport report;
  for (; steps < 1500 && !processor.is_tight(); ++steps) report = processor.step();
  EXPECT_LT(steps, 1500);
  EXPECT_GT(report.pull, 0.05) << "what hangs does not make hands give way";
  EXPECT_LT(std::abs(processor.tightness()->progress), 0.03);
}

// Cloth that its own weight strains to the limit: what breaks that is slowed down where it is,
// which hands do not feel. Without gravity they would have to ease their pull.
TEST(Gravity, hands_pull_on_where_the_weight_is_too_much) {
  Scene scene = scene_of_loop();
  scene.friction = 0.3;
  scene.air_resistance_per_s = 10;
  scene.gravity_m_s2 = Vector3d(0, 0, earths);
  scene.fastening->speed_m_s = 3;
  FasteningProcessor processor =
      FasteningProcessor::create(scene, mesh_of_loop(scene), post(0.3)).value();
  for (int step = 0; step < 150; ++step) {
    EXPECT_EQ(processor.step().pull, 1) << step;
    ASSERT_LE(processor.strain(), paper_strain_limit) << step;
  }
}

// Where the particles are a frame of two steps later, if the scene changes now.
Matrix3Xd a_frame_later(FasteningProcessor& now, const Scene& changed, const RestSize& size) {
  auto later = FasteningProcessor::restore(changed, size, post(post_radius_m), now.state(),
                                           Changed::settings)
                   .value();
  later.step();
  later.step();
  return later.positions();
}

// From rest a free particle goes a t^2 / 2, in air about 5 % less, and in 20 substeps 5 % more.
// What hangs free at the ends answers to gravity so; what lies on the post is held.
TEST(Gravity, a_settled_ribbon_answers_within_a_frame_when_gravity_turns_by_a_degree) {
  const Scene scene = scene_of_drape();
  FasteningProcessor processor = above_the_post(scene);
  for (int step = 0; step < 1000; ++step) processor.step();
  const RestSize size = level_ribbon(scene).size();
  const double degree = std::numbers::pi / 180;
  Scene turned = scene;
  turned.gravity_m_s2 = earths * Vector3d(0, std::sin(degree), -std::cos(degree));
  const Matrix3Xd answer =
      a_frame_later(processor, turned, size) - a_frame_later(processor, scene, size);
  const double free_m = 0.5 * earths * std::sin(degree) * 0.02 * 0.02;
  for (const Eigen::Index end : {0, 58}) {
    const auto rows = answer.middleCols(end * size.grid.across, 3 * size.grid.across);
    EXPECT_GT(rows.row(1).mean(), 0.9 * free_m);
    EXPECT_LT(rows.row(1).mean(), 1.1 * free_m);
  }
  EXPECT_LT(answer.colwise().norm().maxCoeff(), 2 * free_m);
}

// Likewise the hands: each half is drawn towards its end, by as much as the force adds.
TEST(Gravity, a_settled_ribbon_answers_within_a_frame_when_hands_pull) {
  Scene scene = scene_of_drape();
  scene.fastening = FasteningScene{.speed_m_s = 1e-6, .pull = FasteningPull::ends};
  FasteningProcessor processor = above_the_post(scene);
  for (int step = 0; step < 1000; ++step) processor.step();
  const RestSize size = level_ribbon(scene).size();
  Scene pulled = scene;
  pulled.fastening->speed_m_s = 0.01;
  const Matrix3Xd answer =
      a_frame_later(processor, pulled, size) - a_frame_later(processor, scene, size);
  // All of the pull is on four rows at each end, which draw on those above them.
  const double free_m = 0.5 * 8 * 0.01 * 30.5 / 4 * 0.02 * 0.02;
  for (const Eigen::Index end : {0, 60}) {
    const double down_m = -answer.row(2).segment(end * size.grid.across, size.grid.across).mean();
    EXPECT_GT(down_m, 0.1 * free_m);
    EXPECT_LT(down_m, 1.1 * free_m);
  }
}

}  // namespace ribbon::gravity_test

#include "simulation/fastening_processor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "parallel/any_threads.h"
#include "simulation/frame_judge.h"
#include "simulation/loop_scene.h"
#include "simulation/state/edge_strain.h"

namespace ribbon::fastening_processor_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

FasteningProcessor processor(const Scene& scene, const std::optional<TriangleMesh>& obstacle) {
  return FasteningProcessor::create(scene, mesh_of_loop(scene), obstacle).value();
}

TEST(FasteningProcessor, draws_the_loop_tight_and_the_ends_out) {
  FasteningProcessor fastening = processor(scene_of_loop(), post(0.3));
  const Matrix3Xd start = fastening.positions();
  for (int i = 0; i < 150; ++i) fastening.step();
  const Matrix3Xd end = fastening.positions();
  EXPECT_GT((end.col(0) - start.col(0)).norm(), 0.2);
  const Eigen::Index middle = end.cols() / 2;
  EXPECT_LT(std::hypot(end(0, middle), end(2, middle)), 0.4);
  EXPECT_GT(std::hypot(end(0, middle), end(2, middle)), 0.29);
  EXPECT_DOUBLE_EQ(fastening.time_s(), 1.5);
}

TEST(FasteningProcessor, lets_no_edge_through_at_any_step) {
  Scene scene = scene_of_loop();
  scene.fastening->speed_m_s = 2;
  FasteningProcessor fastening = processor(scene, post(0.3));
  const FrameJudge judge(mesh_of_loop(scene), post(0.3));
  for (int i = 0; i < 80; ++i) {
    fastening.step();
    ASSERT_TRUE(judge.is_free(fastening.positions())) << i;
  }
}

TEST(FasteningProcessor, tells_where_the_time_of_its_steps_went) {
  for (const ContactMethod contact : {ContactMethod::gate, ContactMethod::paper}) {
    Scene scene = scene_of_loop();
    scene.contact = contact;
    FasteningProcessor fastening = processor(scene, post(0.3));
    const PhaseSums start = fastening.phase_sums();
    EXPECT_EQ(start.detections, 0);
    const auto before = std::chrono::steady_clock::now();
    for (int i = 0; i < 10; ++i) fastening.step();
    const std::chrono::duration<double> all = std::chrono::steady_clock::now() - before;
    const PhaseSums sums = fastening.phase_sums();
    EXPECT_GE(sums.detections, 10);
    // A step truncates or recovers.
    const StepPhase left_out =
        contact == ContactMethod::gate ? StepPhase::recovery : StepPhase::truncation;
    double phases_s = 0;
    for (std::size_t phase = 0; phase < step_phase_count; ++phase) {
      EXPECT_EQ(sums.time_s[phase] == 0, static_cast<StepPhase>(phase) == left_out) << phase;
      phases_s += sums.time_s[phase];
    }
    EXPECT_LE(phases_s, all.count());
    EXPECT_GT(phases_s, 0.5 * all.count());
  }
}

TEST(FasteningProcessor, tells_what_integrates_its_steps) {
  Scene scene = scene_of_loop();
  EXPECT_EQ(processor(scene, std::nullopt).integrator(), IntegrationMethod::symplectic_euler);
  const int few = processor(scene, std::nullopt).substeps();
  scene.springs.stretch *= 100;
  EXPECT_EQ(processor(scene, std::nullopt).integrator(), IntegrationMethod::symplectic_euler);
  EXPECT_GT(processor(scene, std::nullopt).substeps(), few);
  // Too stiff for the usual one, and the scene names none.
  scene.springs.stretch = 1e9;
  EXPECT_EQ(processor(scene, std::nullopt).integrator(), IntegrationMethod::implicit);
  EXPECT_EQ(processor(scene, std::nullopt).substeps(), 1);
  scene.springs.stretch = 10;
  scene.time.integrator = IntegrationMethod::rk4;
  EXPECT_EQ(processor(scene, std::nullopt).integrator(), IntegrationMethod::rk4);
}

TEST(FasteningProcessor, gives_the_same_bits_for_any_number_of_threads) {
  same_for_any_threads([] {
    FasteningProcessor fastening = processor(scene_of_loop(), post(0.3));
    for (int i = 0; i < 40; ++i) fastening.step();
    return fastening.positions();
  });
}

TEST(FasteningProcessor, drawn_tight_round_a_post_it_knows_that_it_is) {
  for (const FasteningPull pull : {FasteningPull::distributed, FasteningPull::ends}) {
    Scene scene = scene_of_loop();
    scene.fastening->pull = pull;
    scene.fastening->yield_strain = 0.05;
    FasteningProcessor fastening = processor(scene, post(0.3));
    const double loose = fastening.tightness()->contact_share;
    int steps = 0;
    for (; steps < 2000 && !fastening.is_tight(); ++steps) fastening.step();
    EXPECT_GT(steps, 250);
    EXPECT_LT(steps, 1500);
    const Tightness tightness = *fastening.tightness();
    EXPECT_LT(std::abs(tightness.progress), 0.03);
    EXPECT_GT(tightness.contact_share, loose + 0.2);
    EXPECT_GT(tightness.contact_share, 0.3) << "it lies round the post";
  }
}

// Hands that do not yield. Returns the least part of their force that they were left.
double least_pull_within_the_limit(double speed_m_s, int most_rounds_of_correction) {
  Scene scene = scene_of_loop();
  scene.strain_correction.most_rounds = most_rounds_of_correction;
  scene.fastening->speed_m_s = speed_m_s;
  FasteningProcessor fastening = processor(scene, post(0.3));
  const Matrix3Xd start = fastening.positions();
  double least_pull = 1;
  for (int i = 0; i < 25; ++i) {
    const StepReport report = fastening.step();
    least_pull = std::min(least_pull, report.pull);
    EXPECT_LE(fastening.strain(), paper_strain_limit) << i;
  }
  EXPECT_GT((fastening.positions() - start).colwise().norm().maxCoeff(), 0.1);
  return least_pull;
}

TEST(FasteningProcessor, strains_no_edge_beyond_the_limit_whatever_the_force) {
  EXPECT_EQ(least_pull_within_the_limit(4, 20), 1);
  least_pull_within_the_limit(400, 20);
  EXPECT_LT(least_pull_within_the_limit(400, 0), 0.6) << "more than the cloth can bear";
}

// The second difference of the positions, frame by frame at 50 a second: what is seen as shivering.
TEST(FasteningProcessor, what_is_tight_comes_to_rest) {
  Scene scene = scene_of_loop();
  scene.fastening->yield_strain = 0.05;
  FasteningProcessor fastening = processor(scene, post(0.3));
  for (int step = 0; step < 2000 && !fastening.is_tight(); ++step) fastening.step();
  ASSERT_TRUE(fastening.is_tight());
  const auto next_frame = [&] {
    fastening.step();
    fastening.step();
    return fastening.positions();
  };
  for (int frame = 0; frame < 100; ++frame) next_frame();
  Matrix3Xd before = next_frame();
  Matrix3Xd now = next_frame();
  std::vector<double> shivers_m;
  for (int frame = 0; frame < 20; ++frame) {
    const Matrix3Xd after = next_frame();
    for (const double shiver_m : (after - 2 * now + before).colwise().norm())
      shivers_m.push_back(shiver_m);
    before = std::exchange(now, after);
  }
  std::sort(shivers_m.begin(), shivers_m.end());
  EXPECT_LT(shivers_m[shivers_m.size() * 99 / 100], 2.5e-4);
  EXPECT_LT(shivers_m.back(), 1e-3);
}

TEST(FasteningProcessor, is_drawn_no_faster_than_the_speed_limit) {
  Scene scene = scene_of_loop();
  scene.fastening->speed_m_s = 2;
  const auto mean_way_in_half_a_second = [](const Scene& tried) {
    FasteningProcessor fastening = processor(tried, post(0.3));
    const Matrix3Xd start = fastening.positions();
    for (int i = 0; i < 50; ++i) fastening.step();
    return (fastening.positions() - start).colwise().norm().mean();
  };
  const double unlimited_m = mean_way_in_half_a_second(scene);
  scene.fastening->max_speed_m_s = 0.2;
  const double limited_m = mean_way_in_half_a_second(scene);
  EXPECT_GT(unlimited_m, 0.2);
  EXPECT_LT(limited_m, 1.2 * 0.2 * 0.5) << "the springs may add a little";
  EXPECT_GT(limited_m, 0.05);
}

TEST(FasteningProcessor, as_published_recovers_and_reports_how_often) {
  Scene scene = scene_of_loop();
  scene.contact = ContactMethod::paper;
  scene.fastening->speed_m_s = 4;
  FasteningProcessor fastening = processor(scene, post(0.3));
  int recoveries = 0;
  for (int i = 0; i < 80; ++i) recoveries += fastening.step().recovery_iterations;
  EXPECT_GT(recoveries, 0);
  EXPECT_TRUE(fastening.positions().allFinite());
}

}  // namespace ribbon::fastening_processor_test

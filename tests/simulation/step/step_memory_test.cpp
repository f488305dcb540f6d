#include <gtest/gtest.h>

#include <cstddef>

#include "benchmarks/heap_use.h"
#include "parallel/parallel.h"
#include "simulation/fastening_processor.h"
#include "simulation/loop_scene.h"

namespace ribbon::step_memory_test {

constexpr int measured_steps = 20;

// Of some steps after others, in which buffers have found their sizes.
std::size_t allocations_after(int steps, const Scene& scene) {
  FasteningProcessor fastening =
      FasteningProcessor::create(scene, mesh_of_loop(scene), post(0.3)).value();
  for (int step = 0; step < steps; ++step) fastening.step();
  benchmark::restart_heap_use();
  for (int step = 0; step < measured_steps; ++step) fastening.step();
  return benchmark::heap_use().allocations;
}

// With all that takes part in a step. With more threads the scheduler takes memory of its own.
class StepMemory : public testing::TestWithParam<IntegrationMethod> {
 protected:
  StepMemory() : scene(scene_of_small_loop()) {
    set_thread_limit(1);
    scene.time.integrator = GetParam();
    scene.gravity_m_s2 = Eigen::Vector3d(0, -1, 0);
    scene.friction = 0.2;
    scene.fastening->speed_m_s = 2;
    scene.fastening->max_speed_m_s = 1.5;
    scene.fastening->yield_strain = 0.05;
  }
  ~StepMemory() override { set_thread_limit(0); }

  Scene scene;
};

TEST_P(StepMemory, is_not_taken_by_a_loose_step_once_warm) {
  EXPECT_EQ(allocations_after(5, scene), 0U);
}

TEST_P(StepMemory, is_not_taken_by_hands_that_hold_and_pull_in_a_stage) {
  scene.stages = {
      {.until_s = 100,
       .hands = {{.at = Span{0, 0.1}, .task = HandTask::hold, .speed_m_s = 2},
                 {.at = Span{0.4, 0.6}, .task = HandTask::pull_outwards, .speed_m_s = 2},
                 {.at = Span{0.9, 1}, .task = HandTask::hold, .speed_m_s = 2}}}};
  EXPECT_EQ(allocations_after(1000, scene), 0U);
}

// Lists of pairs grow, now and then, until nothing is drawn any tighter.
TEST_P(StepMemory, is_not_taken_by_a_tight_step_once_warm) {
  EXPECT_EQ(allocations_after(1000, scene), 0U);
}

INSTANTIATE_TEST_SUITE_P(WithAnyIntegrator, StepMemory,
                         testing::Values(IntegrationMethod::rk4,
                                         IntegrationMethod::symplectic_euler,
                                         IntegrationMethod::implicit));

}  // namespace ribbon::step_memory_test

// Ribbons of every size and place: each is fastened without an intersection, or refused.
#include <gtest/gtest.h>

#include "result/refusal.h"
#include "simulation/fastening_processor.h"
#include "simulation/frame_judge.h"
#include "simulation/loop_scene.h"

namespace ribbon::extremes_test {

// The loop and its post, `size` times as large, with equal accelerations in proportion.
struct Scaled {
  Scene scene = scene_of_loop();
  RibbonMesh mesh;
  TriangleMesh obstacle = post(0.4);

  explicit Scaled(double size) {
    scene.ribbon.width_m *= size;
    scene.fastening->speed_m_s *= size;
    mesh = mesh_of_loop(scene, size);
    obstacle.vertices *= static_cast<float>(size);
  }
};

void expect_free_for_30_steps(const Scene& scene, const RibbonMesh& mesh,
                              const std::optional<TriangleMesh>& obstacle) {
  auto fastening = FasteningProcessor::create(scene, mesh, obstacle);
  ASSERT_TRUE(fastening.has_value()) << fastening.error().sentence();
  const FrameJudge judge(mesh, obstacle);
  for (int step = 0; step < 30; ++step) {
    ASSERT_TRUE(judge.is_free(fastening->positions())) << step;
    ASSERT_GE(judge.gap_m(fastening->positions()), fastening->guaranteed_gap_m()) << step;
    fastening->step();
  }
}

TEST(Extremes, edges_from_a_tenth_of_a_millimetre_to_a_kilometre) {
  // The shortest edge of the loop is 20 mm.
  for (const double size : {1e-4 / 0.02, 1e-2, 1.0, 1e2, 1e3 / 0.02}) {
    SCOPED_TRACE(size);
    const Scaled scaled(size);
    expect_free_for_30_steps(scaled.scene, scaled.mesh, scaled.obstacle);
  }
}

TEST(Extremes, far_from_the_origin_within_the_limit) {
  Scaled scaled(1);
  scaled.mesh.positions.colwise() += Eigen::Vector3d(300, -200, 500);
  scaled.obstacle.vertices.colwise() += Eigen::Vector3f(300, -200, 500);
  scaled.scene.fastening->axis_point_m = {300, -200, 500};
  expect_free_for_30_steps(scaled.scene, scaled.mesh, scaled.obstacle);
}

TEST(Extremes, a_ribbon_of_four_particles) {
  Scene scene = scene_of_loop();
  const RibbonMesh mesh = mesh_of_four_particles(scene);
  expect_free_for_30_steps(scene, mesh, std::nullopt);
  expect_free_for_30_steps(scene, mesh, post(0.3));
}

TEST(Extremes, a_ribbon_shorter_than_the_way_round) {
  // Pulled by its ends, it leaves the post or lies against it; nothing is pulled through.
  Scene scene = scene_of_loop();
  scene.ribbon.along = 40;
  SpaceCurve arc = loop(120);
  arc.points = arc.points.middleCols(40, 40).eval();
  arc.length_m *= 39.0 / 119;
  const RibbonMesh mesh = generate_ribbon_mesh(arc, scene.ribbon, Axis::y);
  expect_free_for_30_steps(scene, mesh, post(0.4));
}

TEST(Extremes, particles_in_one_place_are_refused_with_their_row) {
  const Scene scene = scene_of_loop();
  RibbonMesh mesh = mesh_of_loop(scene);
  const int first = mesh.grid.particle(60, 0);
  for (int k = 0; k < 12; ++k) mesh.positions.col(first + k) = mesh.positions.col(first);
  EXPECT_THAT(refusal_of(FasteningProcessor::create(scene, mesh, std::nullopt)),
              HasSubstr("row 6"));
}

TEST(Extremes, a_loop_pulled_a_thousand_times_too_hard_stays_free) {
  Scene scene = scene_of_loop();
  scene.fastening->speed_m_s = 400;
  expect_free_for_30_steps(scene, mesh_of_loop(scene), post(0.49));
}

// By each integrator on the post, which is touched after some twenty steps, with the paper's limit
// of strain; or refused, which the last one never does.
void expect_bounded_by_any_integrator(Scene scene) {
  for (const IntegrationMethod method :
       {IntegrationMethod::rk4, IntegrationMethod::symplectic_euler, IntegrationMethod::implicit}) {
    SCOPED_TRACE(static_cast<int>(method));
    scene.time.integrator = method;
    const RibbonMesh mesh = mesh_of_loop(scene);
    auto fastening = FasteningProcessor::create(scene, mesh, post(0.45));
    if (!fastening && method != IntegrationMethod::implicit) {
      EXPECT_THAT(fastening.error().sentence(), HasSubstr("more than 1200; set"));
      EXPECT_THAT(fastening.error().remedy, HasSubstr("time.integrator"));
      continue;
    }
    ASSERT_TRUE(fastening.has_value()) << fastening.error().sentence();
    const FrameJudge judge(mesh, post(0.45));
    for (int step = 0; step < 40; ++step) {
      fastening->step();
      ASSERT_TRUE(judge.is_free(fastening->positions())) << step;
      ASSERT_LT(fastening->strain(), 0.1) << step;
    }
  }
}

TEST(Extremes, springs_without_resistance_and_of_any_resistance) {
  Scene scene = scene_of_small_loop();
  const double particle_mass_kg = scene.ribbon.mass_kg / 240;
  for (const double ratio : {0.0, 1.0, 1e2, 1e4, 3e4, 1e6, 1e8, 1e10, 1e12}) {
    SCOPED_TRACE(ratio);
    const double resistance = ratio * particle_mass_kg;
    scene.springs = {.stretch = resistance, .shear = resistance, .bend = resistance};
    expect_bounded_by_any_integrator(scene);
  }
}

TEST(Extremes, springs_of_one_kind_and_springs_five_orders_apart) {
  Scene scene = scene_of_small_loop();
  for (const SpringScene& springs :
       {SpringScene{.bend = 10}, SpringScene{.stretch = 10}, SpringScene{.shear = 10},
        SpringScene{.stretch = 1e5, .shear = 1, .bend = 1e-5},
        SpringScene{.stretch = 1e-5, .shear = 1, .bend = 1e5}}) {
    SCOPED_TRACE(springs.stretch);
    scene.springs = springs;
    expect_bounded_by_any_integrator(scene);
  }
}

TEST(Extremes, steps_from_ten_microseconds_to_a_tenth_of_a_second) {
  Scene scene = scene_of_small_loop();
  for (const double step_s : {1e-5, 1e-4, 1e-3, 0.1}) {
    SCOPED_TRACE(step_s);
    scene.time.step_s = step_s;
    expect_bounded_by_any_integrator(scene);
  }
}

TEST(Extremes, masses_from_a_microgram_to_a_million_tons) {
  Scene scene = scene_of_small_loop();
  for (const double mass_kg : {1e-9, 1e9}) {
    SCOPED_TRACE(mass_kg);
    scene.ribbon.mass_kg = mass_kg;
    expect_bounded_by_any_integrator(scene);
  }
}

TEST(Extremes, air_from_next_to_none_to_more_than_a_step_can_hold) {
  Scene scene = scene_of_small_loop();
  for (const double per_s : {1e-6, 1e3, 1e6, 1e12}) {
    SCOPED_TRACE(per_s);
    scene.air_resistance_per_s = per_s;
    expect_bounded_by_any_integrator(scene);
  }
}

TEST(Extremes, gravity_of_the_earth_and_a_hundred_times_that) {
  Scene scene = scene_of_small_loop();
  for (const double times : {1.0, 100.0}) {
    SCOPED_TRACE(times);
    scene.gravity_m_s2 = times * Eigen::Vector3d(0, 0, -9.81);
    expect_bounded_by_any_integrator(scene);
  }
}

TEST(Extremes, nothing_at_all_stays_where_it_is) {
  Scene scene = scene_of_small_loop();
  scene.springs = {};
  scene.air_resistance_per_s = 0;
  scene.fastening.reset();
  const RibbonMesh mesh = mesh_of_loop(scene);
  auto fastening = FasteningProcessor::create(scene, mesh, std::nullopt).value();
  const Eigen::Matrix3Xd before = fastening.positions();
  for (int step = 0; step < 10; ++step) fastening.step();
  EXPECT_EQ(fastening.positions(), before);
}

TEST(Extremes, any_number_that_a_scene_may_hold_ends_in_numbers_or_a_refusal) {
  const auto try_scene = [](const auto& change) {
    Scene scene = scene_of_loop();
    change(scene);
    const RibbonMesh mesh = mesh_of_loop(scene);
    auto fastening = FasteningProcessor::create(scene, mesh, post(0.4));
    if (!fastening) {
      EXPECT_FALSE(fastening.error().remedy.empty());
      return;
    }
    const FrameJudge judge(mesh, post(0.4));
    for (int step = 0; step < 5; ++step) fastening->step();
    EXPECT_TRUE(judge.is_free(fastening->positions()));
  };
  for (const double number : {1e-12, 1e12}) {
    SCOPED_TRACE(number);
    try_scene([&](Scene& scene) { scene.ribbon.mass_kg = number; });
    try_scene([&](Scene& scene) { scene.springs.stretch = number; });
    try_scene([&](Scene& scene) { scene.springs.bend = number; });
    try_scene([&](Scene& scene) { scene.air_resistance_per_s = number; });
    try_scene([&](Scene& scene) { scene.fastening->speed_m_s = number; });
    try_scene([&](Scene& scene) { scene.time.step_s = number; });
    try_scene([&](Scene& scene) { scene.ribbon.width_m = number; });
    try_scene([&](Scene& scene) { scene.gravity_m_s2 = {0, 0, -number}; });
  }
}

}  // namespace ribbon::extremes_test

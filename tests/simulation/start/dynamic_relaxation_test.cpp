#include "simulation/start/dynamic_relaxation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/accuracy.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/fastening_processor.h"
#include "simulation/frame_judge.h"
#include "simulation/loop_scene.h"
#include "simulation/state/edge_strain.h"

namespace ribbon::dynamic_relaxation_test {

using Eigen::Matrix3Xd;

// A band that stands upright and rises and falls like a wave, as it does beside crossings: its
// edges are up to 7 % too long and too short.
RibbonMesh mesh_of_wave(const Scene& scene, double rise_m = 0.02) {
  SpaceCurve curve;
  curve.points.resize(3, scene.ribbon.along);
  for (int i = 0; i < scene.ribbon.along; ++i) {
    const double t = static_cast<double>(i) / (scene.ribbon.along - 1);
    curve.points.col(i) << 1.2 * t, rise_m * std::sin(6 * std::numbers::pi * t), 0;
  }
  for (int i = 1; i < scene.ribbon.along; ++i)
    curve.length_m += (curve.points.col(i) - curve.points.col(i - 1)).norm();
  return generate_ribbon_mesh(curve, scene.ribbon, Axis::y);
}

Scene scene_of_wave() {
  Scene scene = scene_of_loop();
  scene.fastening.reset();
  return scene;
}

struct Relaxed {
  Matrix3Xd from;
  Cloth cloth;
  int steps = 0;
  double strain_before = 0;
  double strain = 0;
};

Relaxed relaxed(const Scene& scene, const RibbonMesh& mesh) {
  const RestSize size = mesh.size();
  const SpringNetwork springs = spring_network(size, scene.springs);
  Cloth cloth{mesh.positions, Matrix3Xd::Zero(3, size.grid.particle_count()),
              scene.ribbon.mass_kg / size.grid.particle_count()};
  Bodies bodies(size.grid, std::nullopt);
  const int steps = relax(scene, size, contact_lengths(scene, size), bodies, cloth);
  return {mesh.positions, cloth, steps, worst_strain(springs, mesh.positions),
          worst_strain(springs, cloth.positions)};
}

double farthest_m(const Relaxed& band) {
  return (band.cloth.positions - band.from).colwise().norm().maxCoeff();
}

TEST(DynamicRelaxation, lets_go_of_most_of_the_strain) {
  const Scene scene = scene_of_wave();
  const Relaxed band = relaxed(scene, mesh_of_wave(scene));
  EXPECT_GT(band.strain_before, 0.06);
  EXPECT_LT(band.strain, 0.3 * band.strain_before);
}

TEST(DynamicRelaxation, is_done_when_hardly_any_energy_is_set_free) {
  Scene scene = scene_of_wave();
  scene.springs = {.stretch = 1000, .shear = 1000, .bend = 0};
  const Relaxed band = relaxed(scene, mesh_of_wave(scene));
  EXPECT_GT(band.steps, 1);
  EXPECT_LT(band.steps, 60);
}

TEST(DynamicRelaxation, leaves_a_band_free_and_at_rest_near_where_it_was_drawn) {
  const Scene scene = scene_of_wave();
  const RibbonMesh mesh = mesh_of_wave(scene);
  const Relaxed band = relaxed(scene, mesh);
  EXPECT_TRUE(FrameJudge(mesh, std::nullopt).is_free(band.cloth.positions));
  EXPECT_TRUE(band.cloth.velocities.isZero(0));
  EXPECT_GT(farthest_m(band), 0);
  EXPECT_LT(farthest_m(band), scene.ribbon.width_m);
}

// What is bent, but hardly strained, would unbend as a whole.
TEST(DynamicRelaxation, leaves_a_gentle_arc_as_it_is) {
  Scene scene = scene_of_loop();
  scene.springs.bend = 1000;
  EXPECT_EQ(farthest_m(relaxed(scene, mesh_of_loop(scene))), 0);
}

// A narrow band whose strain would lead it far for its width.
TEST(DynamicRelaxation, ends_when_the_band_leaves_its_drawing) {
  Scene scene = scene_of_wave();
  scene.ribbon.width_m = 0.01;
  const Relaxed band = relaxed(scene, mesh_of_wave(scene, 0.03));
  EXPECT_LT(band.steps, 60);
  EXPECT_GT(farthest_m(band), 0.5 * scene.ribbon.width_m);
  EXPECT_LT(farthest_m(band), 0.65 * scene.ribbon.width_m);
}

TEST(DynamicRelaxation, without_springs_there_is_nothing_to_let_go) {
  Scene scene = scene_of_wave();
  scene.springs = {};
  EXPECT_EQ(farthest_m(relaxed(scene, mesh_of_wave(scene))), 0);
}

TEST(DynamicRelaxation, knows_neither_weight_nor_air_nor_accuracy) {
  const Scene scene = scene_of_wave();
  const Matrix3Xd usual = relaxed(scene, mesh_of_wave(scene)).cloth.positions;
  for (const AccuracyLevel& level : accuracy_levels) {
    Scene other = scene;
    set_accuracy(level, other);
    other.strain_correction = scene.strain_correction;
    other.gravity_m_s2 = Eigen::Vector3d(0, -9.81, 0);
    other.air_resistance_per_s = 1000;
    other.friction = 1;
    EXPECT_EQ(relaxed(other, mesh_of_wave(other)).cloth.positions, usual) << level.word;
  }
}

// Stiff cloth would leap by centimetres a frame, as if shot.
TEST(DynamicRelaxation, stiff_cloth_does_not_leap_in_the_first_steps) {
  Scene scene = scene_of_wave();
  scene.springs = {.stretch = 1000, .shear = 1000, .bend = 100};
  const RibbonMesh mesh = mesh_of_wave(scene);
  auto processor = FasteningProcessor::create(scene, mesh, std::nullopt).value();
  const Matrix3Xd start = processor.positions();
  for (int step = 0; step < 4; ++step) processor.step();
  EXPECT_GT((start - mesh.positions).colwise().norm().maxCoeff(), 0.002);
  EXPECT_LT((processor.positions() - start).colwise().norm().maxCoeff(), 0.003);
}

}  // namespace ribbon::dynamic_relaxation_test

// What slides on an object: as textbooks have it, whatever triangles that is made of.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simulation/fastening_processor.h"
#include "simulation/loop_scene.h"

namespace ribbon::sliding_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double earths = 9.81;

// A floor at height 0 of long triangles all round the origin, so that what crosses the origin
// crosses their edges aslant.
TriangleMesh floor_of_triangles(int count) {
  TriangleMesh floor;
  floor.vertices.resize(3, count + 1);
  floor.triangles.resize(3, count);
  floor.vertices.col(0).setZero();
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.3) / count;
    floor.vertices.col(i + 1) = (20 * Vector3d(std::cos(angle), 0, -std::sin(angle))).cast<float>();
    floor.triangles.col(i) << 0, i + 1, 1 + (i + 1) % count;
  }
  return floor;
}

// A floor at height 0 of squares, each of two triangles, that lie askew to the band's way.
TriangleMesh floor_of_squares(double size_m) {
  const int along = static_cast<int>(std::ceil(1.2 / size_m));
  const int across = static_cast<int>(std::ceil(0.6 / size_m));
  const Vector3d u = size_m * Vector3d(std::cos(0.3), 0, -std::sin(0.3));
  const Vector3d v = size_m * Vector3d(std::sin(0.3), 0, std::cos(0.3));
  TriangleMesh floor;
  floor.vertices.resize(3, Eigen::Index{along + 1} * (across + 1));
  floor.triangles.resize(3, 2 * Eigen::Index{along} * across);
  const auto vertex = [&](int i, int j) { return i * (across + 1) + j; };
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j)
      floor.vertices.col(vertex(i, j)) =
          (Vector3d(-0.4, 0, -0.3) + i * u + (j - 0.1) * v).cast<float>();
  int triangle = 0;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      floor.triangles.col(triangle++) << vertex(i, j), vertex(i, j + 1), vertex(i + 1, j);
      floor.triangles.col(triangle++) << vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1);
    }
  return floor;
}

// A floor at height 0 of strips, each of two triangles, 2 m long across the band's way: their edges
// are parallel to those of its rows.
TriangleMesh floor_of_strips(double width_m) {
  const int count = static_cast<int>(std::ceil(2 / width_m));
  TriangleMesh floor;
  floor.vertices.resize(3, 2 * Eigen::Index{count + 1});
  floor.triangles.resize(3, 2 * Eigen::Index{count});
  for (int i = 0; i <= count; ++i) {
    const double x = -0.5017 + i * width_m;
    floor.vertices.middleCols<2>(2 * Eigen::Index{i}) << static_cast<float>(x),
        static_cast<float>(x), 0, 0, -1, 1;
  }
  for (int i = 0; i < count; ++i) {
    const int first = 2 * i;
    floor.triangles.col(first) << first, first + 1, first + 2;
    floor.triangles.col(first + 1) << first + 2, first + 1, first + 3;
  }
  return floor;
}

// A small band that lies on the floor, which is tilted by this slope, seen from the floor: what
// turns is gravity.
Scene scene_on_slope(double slope, double friction) {
  Scene scene;
  scene.name = "slope";
  scene.ribbon = {.width_m = 0.02, .along = 20, .across = 5, .mass_kg = 0.005};
  scene.springs = {.stretch = 10, .shear = 10, .bend = 10};
  scene.air_resistance_per_s = 1e-3;
  scene.gravity_m_s2 = earths * Vector3d(slope, -1, 0).normalized();
  scene.friction = friction;
  scene.time = {.step_s = 0.01, .duration_s = 1};
  return scene;
}

struct Slide {
  double went_m = 0;
  double rose_m = 0;  // above where it began
};

// In half a second.
Slide slide(const Scene& scene, const TriangleMesh& floor = floor_of_triangles(7)) {
  const Vector3d begin(-0.15, 0.0011, 0);
  const RibbonMesh ribbon =
      generate_ribbon_mesh(straight_curve(scene.ribbon.along, 0.1, begin), scene.ribbon, Axis::z);
  auto processor = FasteningProcessor::create(scene, ribbon, floor).value();
  const Matrix3Xd before = processor.positions();
  while (processor.time_s() < 0.5) processor.step();
  const Matrix3Xd moved = processor.positions() - before;
  return {moved.row(0).mean(), moved.row(1).maxCoeff()};
}

// The way that a body of this acceleration goes in half a second.
double fallen_m(double acceleration_m_s2) {
  return acceleration_m_s2 * 0.5 * 0.5 / 2;
}

TEST(Sliding, without_friction_the_edges_of_a_flat_floor_are_not_in_the_way) {
  for (const double slope : {0.1, 0.4}) {
    SCOPED_TRACE(slope);
    const Slide found = slide(scene_on_slope(slope, 0));
    const double expected_m = fallen_m(earths * slope / std::hypot(1, slope));
    EXPECT_NEAR(found.went_m, expected_m, 0.03 * expected_m);
    EXPECT_LT(found.rose_m, 1e-3);
  }
}

// It passes up to seven squares in a step, in which weight alone would sink it by up to 4 mm, and
// which contact answers a few times, or once.
TEST(Sliding, a_mesh_does_not_brake_it_however_fine_and_however_long_the_step) {
  struct Case {
    IntegrationMethod integrator;
    double step_s, slope, friction, size_m;
  };
  constexpr auto explicit_scheme = IntegrationMethod::symplectic_euler;
  constexpr auto implicit_scheme = IntegrationMethod::implicit;
  for (const auto& [integrator, step_s, slope, friction, size_m] :
       {Case{explicit_scheme, 0.01, 0.4, 0, 0.005}, Case{explicit_scheme, 0.02, 0.4, 0, 0.005},
        Case{explicit_scheme, 0.02, 0.4, 0.2, 0.005}, Case{explicit_scheme, 0.02, 0.1, 0, 0.02},
        Case{implicit_scheme, 0.005, 0.1, 0, 0.005}, Case{implicit_scheme, 0.01, 0.1, 0, 0.02},
        Case{implicit_scheme, 0.01, 0.1, 0, 0.005}, Case{implicit_scheme, 0.02, 0.1, 0, 0.005},
        Case{implicit_scheme, 0.02, 0.4, 0.2, 0.02}}) {
    const bool is_implicit = integrator == implicit_scheme;
    SCOPED_TRACE(testing::Message()
                 << (is_implicit ? "implicit, step " : "step ") << step_s << ", slope " << slope
                 << ", friction " << friction << ", squares " << size_m);
    Scene scene = scene_on_slope(slope, friction);
    scene.time.step_s = step_s;
    scene.time.integrator = integrator;
    double expected_m = fallen_m(earths * (slope - friction) / std::hypot(1, slope));
    if (is_implicit) expected_m *= 1 + step_s / 0.5;  // so much farther backward Euler falls
    const Slide found = slide(scene, floor_of_squares(size_m));
    EXPECT_NEAR(found.went_m, expected_m, 0.025 * expected_m);
    EXPECT_LT(found.rose_m, 1e-3);
  }
}

// As cylinders have them: the corners of a strip are far from where the band lies on it.
TEST(Sliding, over_long_thin_triangles_is_not_braked_in_long_steps) {
  for (const double step_s : {0.01, 0.02, 0.04})
    for (const double slope : {0.1, 0.4}) {
      SCOPED_TRACE(testing::Message() << "step " << step_s << ", slope " << slope);
      Scene scene = scene_on_slope(slope, 0);
      scene.time.step_s = step_s;
      const Slide found = slide(scene, floor_of_strips(0.005));
      // Its last step may end after half a second.
      const double end_s = step_s * std::ceil(0.5 / step_s - 1e-9);
      const double expected_m =
          fallen_m(earths * slope / std::hypot(1, slope)) * end_s * end_s / 0.25;
      EXPECT_NEAR(found.went_m, expected_m, 0.025 * expected_m);
      EXPECT_LT(found.rose_m, 1e-3);
    }
}

// The same floor with three vertices of its own for each triangle, as meshes of many pieces have.
TEST(Sliding, over_a_floor_of_separate_triangles_is_as_over_one_piece) {
  const TriangleMesh floor = floor_of_squares(0.005);
  TriangleMesh pieces;
  pieces.vertices = floor.vertices(Eigen::all, floor.triangles.reshaped());
  pieces.triangles = Eigen::VectorXi::LinSpaced(floor.triangles.size(), 0,
                                                static_cast<int>(floor.triangles.size()) - 1)
                         .reshaped(3, floor.triangles.cols());
  const Scene scene = scene_on_slope(0.4, 0.2);
  EXPECT_NEAR(slide(scene, pieces).went_m, slide(scene, floor).went_m, 1e-3);
}

TEST(Sliding, with_friction_is_slowed_as_coulombs_law_says) {
  const Slide found = slide(scene_on_slope(0.4, 0.2));
  const double expected_m = fallen_m(earths * (0.4 - 0.2) / std::hypot(1, 0.4));
  EXPECT_NEAR(found.went_m, expected_m, 0.03 * expected_m);
}

TEST(Sliding, friction_that_is_more_than_the_slope_holds) {
  EXPECT_LT(slide(scene_on_slope(0.2, 0.25)).went_m, 1e-4);
}

}  // namespace ribbon::sliding_test

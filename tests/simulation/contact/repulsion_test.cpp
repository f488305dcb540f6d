#include "simulation/contact/repulsion.h"

#include <gtest/gtest.h>

namespace ribbon::repulsion_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const FeaturePair pair{FeaturePair::Kind::vertex_triangle, {0, 1, 2, 3}};
const Collision on_corner{{1, -1, 0, 0}, Vector3d::UnitY()};
const Collision inside{{1, -0.5, -0.25, -0.25}, Vector3d::UnitY()};

// Vertex 0 falls with 2 m/s onto a triangle at rest. The first `particles` of the four vertices are
// the ribbon's, the others the obstacle's.
struct Fall {
  explicit Fall(int particles) {
    Matrix3Xd vertices = Matrix3Xd::Zero(3, 4);
    vertices(0, 2) = 1;
    vertices(2, 3) = 1;
    cloth = {vertices.leftCols(particles), Matrix3Xd::Zero(3, particles), 0.5};
    cloth.velocities(1, 0) = -2;
    obstacle = vertices.rightCols(4 - particles);
  }
  void repel(const Collision& collision, double gap_m, double friction, const Matrix3Xd& before) {
    ribbon::repel(pair, collision, gap_m, friction, {before, obstacle}, {cloth.positions, obstacle},
                  cloth);
  }
  void repel(const Collision& collision, double gap_m, double friction = 0) {
    const Matrix3Xd before = cloth.positions;
    repel(collision, gap_m, friction, before);
  }

  Cloth cloth;
  Matrix3Xd obstacle;
};

// By hand: two equal masses meet head on with 2 m/s; the centre keeps -1 m/s, and with a
// restitution of 0.1 they part with 0.2.
TEST(Repulsion, of_two_equal_masses_is_the_textbook_collision) {
  Fall fall(4);
  fall.repel(on_corner, 0);
  EXPECT_NEAR(fall.cloth.velocities(1, 0), -0.9, 1e-12);
  EXPECT_NEAR(fall.cloth.velocities(1, 1), -1.1, 1e-12);
}

TEST(Repulsion, conserves_momentum_and_centre_of_mass) {
  Fall fall(4);
  const Vector3d momentum = fall.cloth.velocities.rowwise().sum();
  const Vector3d centre = fall.cloth.positions.rowwise().mean();
  fall.repel(inside, 0.3);
  EXPECT_TRUE(fall.cloth.velocities.rowwise().sum().isApprox(momentum, 1e-12));
  EXPECT_TRUE(fall.cloth.positions.rowwise().mean().isApprox(centre, 1e-12));
}

TEST(Repulsion, opens_the_gap_and_reverses_the_approach) {
  Fall fall(4);
  fall.repel(inside, 0.3);
  EXPECT_NEAR((fall.cloth.positions * inside.weights)[1], 0.3, 1e-12);
  EXPECT_NEAR((fall.cloth.velocities * inside.weights)[1], 0.2, 1e-12);
}

TEST(Repulsion, leaves_parting_features_their_velocity) {
  Fall fall(4);
  fall.cloth.velocities(1, 0) = 3;
  fall.repel(inside, 0);
  EXPECT_EQ(fall.cloth.velocities(1, 0), 3);
}

TEST(Repulsion, an_obstacle_of_boundless_mass_stays) {
  Fall fall(1);
  fall.repel(inside, 0.3);
  EXPECT_EQ(fall.cloth.positions.cols(), 1);
  EXPECT_NEAR(fall.cloth.positions(1, 0), 0.3, 1e-12);
  EXPECT_NEAR(fall.cloth.velocities(1, 0), 0.2, 1e-12);
}

// By hand: 2 m/s of approach become 2.2 m/s of change along the normal; a coefficient of 0.5 takes
// at most 1.1 m/s off the sliding. Between two equal masses each gets half of it.
TEST(Repulsion, friction_slows_sliding_in_proportion_to_the_normal_change) {
  Fall fall(4);
  fall.cloth.velocities(0, 0) = 3;
  fall.repel(on_corner, 0, 0.5);
  EXPECT_NEAR(fall.cloth.velocities(0, 0), 3 - 0.55, 1e-12);
  EXPECT_NEAR(fall.cloth.velocities(0, 1), 0.55, 1e-12);
  EXPECT_NEAR(fall.cloth.velocities(1, 0), -0.9, 1e-12);
}

TEST(Repulsion, friction_stops_but_never_reverses_sliding) {
  Fall fall(1);
  fall.cloth.velocities(2, 0) = -0.3;
  fall.repel(on_corner, 0, 0.5);
  EXPECT_NEAR(fall.cloth.velocities(2, 0), 0, 1e-12);
}

// By hand: the gap opens by 0.2 m, so friction 0.5 takes back 0.1 m of the 0.4 m that were slid.
TEST(Repulsion, friction_takes_back_what_was_slid_under_pressure) {
  Fall fall(1);
  fall.cloth.velocities.setZero();
  const Matrix3Xd before = fall.cloth.positions;
  fall.cloth.positions(0, 0) += 0.4;
  fall.repel(on_corner, 0.2, 0.5, before);
  EXPECT_NEAR(fall.cloth.positions(0, 0), 0.3, 1e-12);
  EXPECT_NEAR(fall.cloth.positions(1, 0), 0.2, 1e-12);
}

TEST(Repulsion, friction_conserves_momentum) {
  Fall fall(4);
  fall.cloth.velocities(0, 0) = 3;
  const Vector3d momentum = fall.cloth.velocities.rowwise().sum();
  fall.repel(inside, 0.3, 0.7);
  EXPECT_TRUE(fall.cloth.velocities.rowwise().sum().isApprox(momentum, 1e-12));
}

}  // namespace ribbon::repulsion_test

#include "knot/motion/view_cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace ribbon::view_cones_test {

double clearance_of(const SweptEdge& swept, const Eigen::Vector3d& direction) {
  std::vector<ViewCone> cones;
  append_view_cones(swept, cones);
  return clearance_rad(cones, direction.normalized());
}

TEST(ViewCones, nothing_in_the_way_is_clear_all_round) {
  EXPECT_EQ(clearance_rad({}, Eigen::Vector3d::UnitX()), std::numbers::pi);
}

TEST(ViewCones, clearance_is_the_angle_to_the_nearest_point) {
  const Eigen::Vector3d p(1, 0, 0);
  const Eigen::Vector3d q(1, 1, 0);
  const SweptEdge still{p, q, p, q};
  EXPECT_NEAR(clearance_of(still, {0, 0, 1}), std::numbers::pi / 2, 0.04);
  EXPECT_NEAR(clearance_of(still, {1, 0, 1}), std::numbers::pi / 4, 0.04);
  EXPECT_NEAR(clearance_of(still, {-1, -1, 0}), 3 * std::numbers::pi / 4, 0.07);
  EXPECT_LE(clearance_of(still, {1, 0.5, 0}), 0);
}

TEST(ViewCones, an_edge_that_passes_in_between_is_in_the_way) {
  // Seen to the left before, to the right after.
  const SweptEdge swept{Eigen::Vector3d(1, 1, -1), Eigen::Vector3d(1, 1, 1),
                        Eigen::Vector3d(1, -1, -1), Eigen::Vector3d(1, -1, 1)};
  EXPECT_LE(clearance_of(swept, {1, 0, 0}), 0);
  EXPECT_GT(clearance_of(swept, {-1, 0, 0}), 1);
}

TEST(ViewCones, an_edge_through_the_eye_blocks_every_view) {
  const SweptEdge swept{Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(-1, 1, 0),
                        Eigen::Vector3d(1, -1, 0), Eigen::Vector3d(-1, -1, 0)};
  EXPECT_LE(clearance_of(swept, {0, 0, 1}), 0);
}

TEST(ViewCones, a_point_in_the_eye_blocks_every_view_by_one_cone) {
  const SweptEdge swept{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                        Eigen::Vector3d::Zero()};
  std::vector<ViewCone> cones;
  append_view_cones(swept, cones);
  ASSERT_EQ(cones.size(), 1U);
  EXPECT_LE(clearance_rad(cones, Eigen::Vector3d::UnitZ()), 0);
}

// However many cones lie farther off, in whatever order.
TEST(ViewCones, clearance_is_the_least_of_those_of_single_cones) {
  std::mt19937 random(7);
  std::normal_distribution<double> coordinate;
  const auto direction = [&] {
    return Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random)).normalized();
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<ViewCone> cones(1 + random() % 50);
    for (ViewCone& cone : cones) cone = {direction(), 0.03 * std::abs(coordinate(random))};
    const Eigen::Vector3d view =
        round % 2 == 0 ? direction()
                       : Eigen::Vector3d(cones.back().axis + 1e-7 * direction()).normalized();
    double least = std::numbers::pi;
    for (const ViewCone& cone : cones) least = std::min(least, clearance_rad({cone}, view));
    EXPECT_EQ(clearance_rad(cones, view), least);
  }
}

TEST(ViewCones, no_ray_that_meets_a_surface_close_to_the_eye_is_clear) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int round = 0; round < 300; ++round) {
    SweptEdge swept;
    for (Eigen::Vector3d& corner : swept)
      corner = Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
    // Its middle nearly is the eye.
    const double near = std::pow(10, -2 - 4 * std::abs(coordinate(random)));
    const Eigen::Vector3d beside(near * coordinate(random), near * coordinate(random), 0);
    swept[3] = beside - swept[0] - swept[1] - swept[2];
    std::vector<ViewCone> cones;
    append_view_cones(swept, cones);
    for (int ray = 0; ray < 20; ++ray) {
      const double way = 0.5 + near * coordinate(random);
      const double time = 0.5 + near * coordinate(random);
      const Eigen::Vector3d met = (1 - time) * ((1 - way) * swept[0] + way * swept[1]) +
                                  time * ((1 - way) * swept[2] + way * swept[3]);
      EXPECT_LE(clearance_rad(cones, met.normalized()), 1e-9);
    }
  }
}

TEST(ViewCones, no_ray_that_meets_the_swept_edge_is_clear) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 300; ++round) {
    SweptEdge swept;
    for (Eigen::Vector3d& corner : swept)
      corner = Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
    const double way = share(random);
    const double time = share(random);
    const Eigen::Vector3d met = (1 - time) * ((1 - way) * swept[0] + way * swept[1]) +
                                time * ((1 - way) * swept[2] + way * swept[3]);
    EXPECT_LE(clearance_of(swept, met), 1e-9);
  }
}

}  // namespace ribbon::view_cones_test

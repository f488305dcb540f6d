#include "simulation/fastening/speed_limit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::speed_limit_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double mass_kg = 0.5;
constexpr double air_per_s = 4;
constexpr double step_s = 0.1;

const SpeedLimit limit(2, mass_kg, air_per_s, step_s);

Vector3d limited(const Vector3d& velocity, const Vector3d& force) {
  Matrix3Xd forces = force;
  limit.apply(velocity, forces);
  return forces;
}

// By hand: v' = F / m - a v has v(t) = F / (m a) + (v(0) - F / (m a)) exp(-a t).
double speed_after_a_step(double speed_m_s, double force_n) {
  const double final_m_s = force_n / (mass_kg * air_per_s);
  return final_m_s + (speed_m_s - final_m_s) * std::exp(-air_per_s * step_s);
}

TEST(SpeedLimit, leaves_a_force_alone_that_does_not_reach_it) {
  const Vector3d force(3, 0, 0);
  EXPECT_LT(speed_after_a_step(0, 3), 2);
  EXPECT_EQ(limited(Vector3d::Zero(), force), force);
}

TEST(SpeedLimit, a_strong_force_reaches_it_in_one_step_and_no_more) {
  const Vector3d force = limited(Vector3d(0.5, 0, 0), Vector3d(1000, 0, 0));
  EXPECT_NEAR(speed_after_a_step(0.5, force.x()), 2, 1e-12);
}

TEST(SpeedLimit, at_the_limit_what_the_air_takes_is_still_made_up_for) {
  EXPECT_NEAR(limited(Vector3d(2, 0, 0), Vector3d(1000, 0, 0)).x(), mass_kg * air_per_s * 2, 1e-12);
}

TEST(SpeedLimit, does_not_pull_what_is_much_too_fast) {
  EXPECT_EQ(limited(Vector3d(10, 0, 0), Vector3d(1, 0, 0)), Vector3d::Zero());
}

TEST(SpeedLimit, only_the_speed_along_the_force_counts) {
  const Vector3d force(0, 3, 0);
  EXPECT_EQ(limited(Vector3d(10, 0, 0), force), force);
}

TEST(SpeedLimit, keeps_the_direction_and_minds_no_force_at_all) {
  const Vector3d force = limited(Vector3d::Zero(), Vector3d(300, 0, 400));
  EXPECT_TRUE(force.normalized().isApprox(Vector3d(0.6, 0, 0.8)));
  EXPECT_EQ(limited(Vector3d(1, 1, 1), Vector3d::Zero()), Vector3d::Zero());
}

}  // namespace ribbon::speed_limit_test

#include "model/outward_direction.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::outward_direction_test {

using Normals = std::vector<Eigen::Vector3d>;

double least_cosine(const Normals& normals, const Eigen::Vector3d& direction) {
  double least = 1;
  for (const Eigen::Vector3d& normal : normals) least = std::min(least, normal.dot(direction));
  return least;
}

TEST(OutwardDirection, is_the_mean_of_faces_that_look_much_the_same_way) {
  const Normals normals{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
  const OutwardDirection found = outward_direction(normals);
  EXPECT_NEAR((found.direction - Eigen::Vector3d(1, 1, 0).normalized()).norm(), 0, 1e-15);
  EXPECT_NEAR(found.least_cosine, std::sqrt(0.5), 1e-15);
}

TEST(OutwardDirection, looks_away_from_a_face_that_the_mean_does_not) {
  const Eigen::Vector3d many = Eigen::Vector3d(5, 0, 1).normalized();
  const Eigen::Vector3d one = Eigen::Vector3d(-5, 0, 1).normalized();
  const Normals normals{many, many, many, one};
  const OutwardDirection found = outward_direction(normals);
  EXPECT_NEAR(found.direction.z(), 1, 1e-12);
  EXPECT_NEAR(found.least_cosine, least_cosine(normals, found.direction), 1e-15);
  EXPECT_GT(found.least_cosine, 0.19);
}

TEST(OutwardDirection, of_three_faces_is_in_the_middle_between_them) {
  Normals normals(3, Eigen::Vector3d(1, 0, 0.05).normalized());
  normals.emplace_back(Eigen::Vector3d(-0.5, 0.9, 0.05).normalized());
  normals.emplace_back(Eigen::Vector3d(-0.5, -0.9, 0.05).normalized());
  const OutwardDirection found = outward_direction(normals);
  EXPECT_GT(found.least_cosine, 0.04);
  for (int k = 0; k < 1000; ++k) {
    const double height = 1 - (k + 0.5) / 500;
    const double radius = std::sqrt(1 - height * height);
    const Eigen::Vector3d other(radius * std::cos(2.4 * k), radius * std::sin(2.4 * k), height);
    EXPECT_LE(least_cosine(normals, other), found.least_cosine) << other.transpose();
  }
}

TEST(OutwardDirection, there_is_none_where_faces_look_all_ways) {
  const Normals normals{Eigen::Vector3d(1, 0, -0.2).normalized(),
                        Eigen::Vector3d(-0.5, 0.9, -0.2).normalized(),
                        Eigen::Vector3d(-0.5, -0.9, -0.2).normalized(), Eigen::Vector3d::UnitZ()};
  EXPECT_LT(outward_direction(normals).least_cosine, 0);
}

}  // namespace ribbon::outward_direction_test

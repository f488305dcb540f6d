#include "verification/feature_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ribbon::feature_distance_test {

using Eigen::Vector3f;
using Point = Eigen::Matrix<long double, 3, 1>;

Point exact(const Vector3f& point) {
  return point.cast<long double>();
}

long double from_segment(const Point& p, const Point& a, const Point& b) {
  if (a == b) return (p - a).norm();
  const long double t = (p - a).dot(b - a) / (b - a).squaredNorm();
  return (p - a - std::clamp(t, 0.0L, 1.0L) * (b - a)).norm();
}

// The smallest value of a convex function on [0, 1], by thirds.
template <class Function>
double smallest(const Function& distance) {
  long double low = 0;
  long double high = 1;
  for (int round = 0; round < 150; ++round) {
    const long double third = (high - low) / 3;
    if (distance(low + third) < distance(high - third))
      high -= third;
    else
      low += third;
  }
  return static_cast<double>(distance(low));
}

// The distance of two points of the shapes, hardly more than the smallest there is. The triangle is
// swept by segments parallel to ac.
double near_point_triangle(const Vector3f& p, const Vector3f& a, const Vector3f& b,
                           const Vector3f& c) {
  return smallest([&](long double t) {
    return from_segment(exact(p), exact(a) + t * (exact(b) - exact(a)),
                        exact(c) + t * (exact(b) - exact(c)));
  });
}

double near_segments(const Vector3f& a, const Vector3f& b, const Vector3f& c, const Vector3f& d) {
  return smallest([&](long double t) {
    return from_segment(exact(a) + t * (exact(b) - exact(a)), exact(c), exact(d));
  });
}

TEST(PointTriangleDistance, is_known_inside_at_edges_and_at_corners) {
  const Vector3f a(0, 0, 0);
  const Vector3f b(4, 0, 0);
  const Vector3f c(0, 4, 0);
  EXPECT_NEAR(certain_point_triangle_distance({1, 1, -3}, a, b, c), 3, 1e-13);
  EXPECT_NEAR(certain_point_triangle_distance({2, -3, 4}, a, b, c), 5, 1e-13);
  EXPECT_NEAR(certain_point_triangle_distance({4, 4, 0}, a, b, c), std::sqrt(8), 1e-13);
  EXPECT_NEAR(certain_point_triangle_distance({-2, -3, 6}, a, b, c), 7, 1e-13);
  EXPECT_EQ(certain_point_triangle_distance({1, 1, 0}, a, b, c), 0);
  EXPECT_EQ(certain_point_triangle_distance(b, a, b, c), 0);
}

TEST(SegmentsDistance, is_known_inside_at_ends_and_for_parallels) {
  const Vector3f a(-1, 0, 0);
  const Vector3f b(1, 0, 0);
  EXPECT_NEAR(certain_segments_distance(a, b, {0, -1, 2}, {0, 1, 2}), 2, 1e-13);
  EXPECT_NEAR(certain_segments_distance(a, b, {0, 3, 4}, {0, 9, 4}), 5, 1e-13);
  EXPECT_NEAR(certain_segments_distance(a, b, {4, 4, 0}, {9, 4, 0}), 5, 1e-13);
  EXPECT_NEAR(certain_segments_distance(a, b, {0, 0, 3}, {7, 0, 3}), 3, 1e-13);
  EXPECT_EQ(certain_segments_distance(a, b, {0, -1, 0}, {0, 1, 0}), 0);
  EXPECT_EQ(certain_segments_distance(a, b, b, {5, 5, 5}), 0);
}

TEST(FeatureDistances, degenerate_shapes_are_segments_and_points) {
  const Vector3f p(0, 3, 4);
  const Vector3f a(0, 0, 0);
  EXPECT_NEAR(certain_point_triangle_distance(p, a, a, a), 5, 1e-13);
  EXPECT_NEAR(certain_point_triangle_distance(p, {-1, 0, 0}, {3, 0, 0}, {1, 0, 0}), 5, 1e-13);
  EXPECT_NEAR(certain_segments_distance(p, p, a, a), 5, 1e-13);
  EXPECT_NEAR(certain_segments_distance(p, p, {-1, 0, 0}, {1, 0, 0}), 5, 1e-13);
  EXPECT_EQ(certain_point_triangle_distance(a, a, a, a), 0);
  EXPECT_EQ(certain_segments_distance(a, a, a, a), 0);
}

TEST(FeatureDistances, tiny_and_huge_shapes_are_measured_too) {
  for (const float unit : {0x1p-148F, 0x1p-140F, 0x1p-90F, 0x1p+90F, 0x1p+125F}) {
    const double expected = 3.0 * static_cast<double>(unit);
    const Vector3f a = Vector3f(0, 0, 0) * unit;
    const Vector3f b = Vector3f(4, 0, 0) * unit;
    const Vector3f c = Vector3f(0, 4, 0) * unit;
    EXPECT_NEAR(certain_point_triangle_distance(Vector3f(1, 1, -3) * unit, a, b, c) / expected, 1,
                1e-13);
    EXPECT_NEAR(
        certain_segments_distance(a, b, Vector3f(1, -1, 3) * unit, Vector3f(1, 1, 3) * unit) /
            expected,
        1, 1e-13);
  }
}

// Coordinates of which sums and halves are numbers, too.
class TouchingFeatures : public testing::Test {
 protected:
  Vector3f point() {
    const auto coordinate = [&] { return static_cast<float>(steps_(random_)) * 0x1p-20F; };
    const float x = coordinate();
    const float y = coordinate();
    return {x, y, coordinate()};
  }

 private:
  std::mt19937 random_{11};
  std::uniform_int_distribution<int> steps_{-(1 << 18), 1 << 18};
};

// By the arithmetic of the bound they often seem to lie apart a little.
TEST_F(TouchingFeatures, have_no_distance) {
  for (int trial = 0; trial < 2000; ++trial) {
    const Vector3f a = point();
    const Vector3f b = point();
    const Vector3f c = point();
    const Vector3f inside = (a + b + 2 * c) / 4;
    ASSERT_EQ(4 * exact(inside), exact(a) + exact(b) + 2 * exact(c));
    EXPECT_EQ(certain_point_triangle_distance(inside, a, b, c), 0);
    EXPECT_EQ(certain_segments_distance(a, 2 * inside - a, b, 2 * inside - b), 0);
  }
}

class RandomFeatures : public testing::TestWithParam<float> {
 protected:
  Vector3f point() {
    std::uniform_real_distribution<float> coordinate(-1, 1);
    Vector3f p(coordinate(random_), coordinate(random_), coordinate(random_));
    p.z() *= GetParam();  // the flatter, the worse the conditioning
    return p + Vector3f(5, 7, -3);
  }
  // `certain` is at most the true distance, and short of it by rounding only. The search's own
  // rounding is below 1e-17.
  void expect_certain(double certain, double upper_bound) {
    ASSERT_LE(certain, upper_bound + 1e-17);
    EXPECT_GE(certain, upper_bound - 1e-9);
  }

 private:
  std::mt19937 random_{7};
};

TEST_P(RandomFeatures, the_bound_is_below_the_distance_and_near_it) {
  for (int trial = 0; trial < 500; ++trial) {
    const Vector3f a = point();
    const Vector3f b = point();
    const Vector3f c = point();
    const Vector3f d = point();
    expect_certain(certain_point_triangle_distance(a, b, c, d), near_point_triangle(a, b, c, d));
    expect_certain(certain_segments_distance(a, b, c, d), near_segments(a, b, c, d));
  }
}

TEST_P(RandomFeatures, nearly_parallel_segments_are_no_exception) {
  for (int trial = 0; trial < 500; ++trial) {
    const Vector3f a = point();
    const Vector3f b = point();
    const Vector3f c = point();
    const Vector3f d = c + (b - a) * 0.7F;  // parallel but for its rounding
    expect_certain(certain_segments_distance(a, b, c, d), near_segments(a, b, c, d));
  }
}

INSTANTIATE_TEST_SUITE_P(Flatness, RandomFeatures, testing::Values(1.0F, 1e-3F, 1e-6F));

}  // namespace ribbon::feature_distance_test

#include "ribbon_mesh/width_vectors.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

namespace ribbon::width_vectors_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const Vector3d up = Vector3d::UnitY();

// `count` points of a curve given over [0, 1], about evenly spaced.
Matrix3Xd sampled(int count, const std::function<Vector3d(double)>& curve) {
  Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i) points.col(i) = curve(static_cast<double>(i) / (count - 1));
  return points;
}

TEST(WidthVectors, of_a_plan_circle_are_the_axis_whichever_way_it_turns) {
  for (const double way : {1.0, -1.0}) {
    const Matrix3Xd circle = sampled(
        200, [way](double t) { return Vector3d(std::cos(5 * t), 0, way * std::sin(5 * t)); });
    const Matrix3Xd widths = width_vectors(circle, up, 0.1);
    for (int i = 0; i < widths.cols(); ++i) EXPECT_TRUE(widths.col(i).isApprox(up, 1e-9)) << i;
  }
}

TEST(WidthVectors, of_a_straight_line_where_the_formula_degenerates_are_the_axis) {
  const Matrix3Xd widths =
      width_vectors(sampled(50, [](double t) { return Vector3d(t, 0, 2 * t); }), up, 0.1);
  for (int i = 0; i < widths.cols(); ++i) EXPECT_TRUE(widths.col(i).isApprox(up, 1e-9)) << i;
}

TEST(WidthVectors, do_not_turn_over_at_an_inflection) {
  const Matrix3Xd s_curve = sampled(
      300, [](double t) { return Vector3d(t, 0, 0.1 * std::sin(2 * std::numbers::pi * t)); });
  const Matrix3Xd widths = width_vectors(s_curve, up, 0.05);
  for (int i = 1; i < widths.cols(); ++i) EXPECT_GT(widths.col(i).dot(widths.col(i - 1)), 0.99);
}

TEST(WidthVectors, are_unit_and_orthogonal_to_a_curve_that_rises_and_falls) {
  const Matrix3Xd wave = sampled(400, [](double t) {
    return Vector3d(std::cos(6 * t), 0.1 * std::sin(20 * t), std::sin(6 * t));
  });
  const Matrix3Xd widths = width_vectors(wave, up, 0.1);
  for (int i = 1; i + 1 < widths.cols(); ++i) {
    EXPECT_NEAR(widths.col(i).norm(), 1, 1e-12);
    EXPECT_NEAR(widths.col(i).dot((wave.col(i + 1) - wave.col(i - 1)).normalized()), 0, 1e-9);
    EXPECT_GT(widths.col(i).dot(up), 0);
  }
}

TEST(WidthVectors, lean_so_that_the_band_bends_about_its_width) {
  // A helix turns about its binormal (by hand: pitch angle a, binormal = cos a * up - sin a *
  // side).
  const double rise = 0.5;
  const Matrix3Xd helix = sampled(
      2000, [rise](double t) { return Vector3d(std::cos(9 * t), rise * 9 * t, -std::sin(9 * t)); });
  const Matrix3Xd widths = width_vectors(helix, up, 2.0);
  const double pitch = std::atan(rise);
  EXPECT_NEAR(widths.col(1000).dot(up), std::cos(pitch), 0.02);
}

TEST(WidthVectors, begin_with_the_axis) {
  const Matrix3Xd arc = sampled(100, [](double t) { return Vector3d(t, t * t, t * t * t); });
  const Vector3d first = width_vectors(arc, up, 0.05).col(0);
  const Vector3d direction = (arc.col(1) - arc.col(0)).normalized();
  EXPECT_TRUE(first.isApprox((up - up.dot(direction) * direction).normalized(), 1e-12));
}

}  // namespace ribbon::width_vectors_test

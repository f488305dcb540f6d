#include "player/view/framing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace ribbon::framing_test {

Eigen::Matrix3Xf cloud(float scale) {
  Eigen::Matrix3Xf points(3, 200);
  for (int i = 0; i < 200; ++i) {
    const auto t = static_cast<float>(i);
    points.col(i) << scale * 2 * std::sin(t), 0.4F + scale * std::sin(1.3F * t),
        scale * 0.7F * std::cos(2.1F * t);
  }
  return points;
}

Camera camera_of(const View& view, std::initializer_list<Eigen::Matrix3Xf> clouds,
                 const PictureSize& size = {}) {
  Framing framing(view, size);
  for (const Eigen::Matrix3Xf& points : clouds) framing.include(points);
  return framing.camera();
}

// How near any point comes to the border of the picture.
float widest(const Camera& camera, const Eigen::Matrix3Xf& points) {
  float widest = 0;
  for (const auto point : points.colwise()) {
    const Eigen::Vector3f seen = camera.project(point);
    EXPECT_GT(seen.z(), 0);
    widest = std::max(widest, seen.head<2>().cwiseAbs().maxCoeff());
  }
  return widest;
}

TEST(Framing, every_point_is_inside_with_a_margin_and_some_point_touches_it) {
  for (const View& view : {three_quarter_view, top_view, View{-130, -40}, View{0, 90}})
    for (const PictureSize size : {PictureSize{1280, 720}, PictureSize{300, 900}}) {
      const Camera camera = camera_of(view, {cloud(0.5F), cloud(1.5F)}, size);
      EXPECT_LE(widest(camera, cloud(0.5F)), 0.921F);
      EXPECT_NEAR(widest(camera, cloud(1.5F)), 0.92F, 0.001F);
    }
}

TEST(Framing, what_is_tiny_fills_the_picture_as_well) {
  for (const float scale : {1e-2F, 1e-3F, 2e-4F})
    EXPECT_NEAR(widest(camera_of(three_quarter_view, {cloud(scale)}), cloud(scale)), 0.92F, 0.01F)
        << scale;
}

TEST(Framing, the_order_of_points_does_not_matter) {
  EXPECT_EQ(camera_of(three_quarter_view, {cloud(1), cloud(2)}).eye,
            camera_of(three_quarter_view, {cloud(2), cloud(1)}).eye);
}

TEST(Framing, a_single_point_can_be_looked_at) {
  const Eigen::Vector3f point(3, 4, 5);
  const Eigen::Vector3f seen = camera_of(three_quarter_view, {point}).project(point);
  EXPECT_GT(seen.z(), 0);
  EXPECT_NEAR(seen.x(), 0, 1e-2);
  EXPECT_NEAR(seen.y(), 0, 1e-2);
}

TEST(Framing, the_three_quarter_view_looks_from_the_front_the_right_and_above) {
  const Camera camera = camera_of(three_quarter_view, {cloud(1)});
  EXPECT_GT(camera.eye.x(), 0.5F);
  EXPECT_GT(camera.eye.y(), 0.5F);
  EXPECT_GT(camera.eye.z(), 0.5F);
  // Up stays up.
  EXPECT_GT(camera.project({0, 1, 0}).y(), camera.project({0, 0, 0}).y());
}

TEST(Framing, the_front_is_below_in_the_top_view) {
  const Camera camera = camera_of(top_view, {cloud(1)});
  EXPECT_LT(camera.project({0, 0, 1}).y(), camera.project({0, 0, 0}).y());
  EXPECT_GT(camera.project({1, 0, 0}).x(), camera.project({0, 0, 0}).x());
}

TEST(Camera, directions_lead_to_where_points_appear) {
  const Camera camera = camera_of(three_quarter_view, {cloud(1)});
  const Eigen::Vector3f point = camera.eye + 3 * camera.direction(0.25F, -0.5F);
  const Eigen::Vector3f seen = camera.project(point);
  EXPECT_NEAR(seen.x(), 0.25F, 1e-4);
  EXPECT_NEAR(seen.y(), -0.5F, 1e-4);
  EXPECT_NEAR(seen.z(), 3, 1e-4);
}

}  // namespace ribbon::framing_test

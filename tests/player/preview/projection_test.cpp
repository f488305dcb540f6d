#include "player/preview/projection.h"

#include <gtest/gtest.h>

#include "player/view/orbit.h"

namespace ribbon::projection_test {

const Camera camera = orbit_camera(three_quarter_view, {1280, 720}, {0.1F, 0.2F, 0.3F}, 4);

TEST(Projection, points_appear_where_the_camera_puts_them) {
  const Eigen::Matrix4f clip = clip_from_world(camera, {1, 9});
  for (const Eigen::Vector3f& point : {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(0.5F, 0.4F, -1)}) {
    const Eigen::Vector4f place = clip * point.homogeneous();
    const Eigen::Vector3f expected = camera.project(point);
    EXPECT_NEAR(place.x() / place.w(), expected.x(), 1e-5F);
    EXPECT_NEAR(place.y() / place.w(), expected.y(), 1e-5F);
    EXPECT_NEAR(place.w(), expected.z(), 1e-5F);
  }
}

TEST(Projection, depth_tells_everything_in_the_box_apart) {
  const Eigen::AlignedBox3f box(Eigen::Vector3f(-1, -0.5F, -1), Eigen::Vector3f(1, 0.5F, 1));
  const Eigen::Matrix4f clip = clip_from_world(camera, depth_range(camera, box));
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3f point = box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner));
    const Eigen::Vector4f place = clip * point.homogeneous();
    EXPECT_GT(place.z() / place.w(), -1);
    EXPECT_LT(place.z() / place.w(), 1);
  }
}

TEST(Projection, a_camera_inside_the_box_sees_what_is_before_it) {
  const Eigen::AlignedBox3f box(Eigen::Vector3f::Constant(-9), Eigen::Vector3f::Constant(9));
  const DepthRange range = depth_range(camera, box);
  EXPECT_GT(range.nearest, 0);
  EXPECT_LT(range.nearest, 0.1F);
  EXPECT_GT(range.farthest, 9);
}

}  // namespace ribbon::projection_test

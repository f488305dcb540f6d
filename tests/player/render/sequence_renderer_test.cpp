#include "player/render/sequence_renderer.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "recording/sample_recording.h"

namespace ribbon::sequence_renderer_test {

std::filesystem::path recorded(int frames) {
  std::filesystem::path path = temporary_file("shown.rbn");
  write_sample_recording(path, frames);
  return path;
}

TEST(SequenceRenderer, the_camera_sees_every_particle_of_every_frame_and_the_obstacle) {
  auto reader = RecordingReader::open(recorded(12));
  ASSERT_TRUE(reader) << reader.error().sentence();
  const auto cameras =
      frame_cameras(*reader, {{three_quarter_view, {1280, 720}}, {top_view, {420, 320}}});
  ASSERT_EQ(cameras.size(), 2U);
  for (const Camera& camera : cameras) {
    const auto expect_inside = [&camera](const Eigen::Matrix3Xf& points) {
      for (const auto point : points.colwise()) {
        const Eigen::Vector3f seen = camera.project(point);
        EXPECT_GT(seen.z(), 0);
        EXPECT_LT(seen.head<2>().cwiseAbs().maxCoeff(), 0.93F);
      }
    };
    for (int frame = 0; frame < 12; ++frame) expect_inside(sample_positions(frame).cast<float>());
    expect_inside(sample_header().obstacle->vertices);
  }
}

TEST(SequenceRenderer, a_frame_looks_the_same_whatever_was_shown_before) {
  auto reader = RecordingReader::open(recorded(5));
  ASSERT_TRUE(reader) << reader.error().sentence();
  const PictureSize size{160, 90};
  const auto cameras = frame_cameras(*reader, {{three_quarter_view, size}});
  SequenceRenderer backwards(*reader, 4);
  std::vector<Picture> pictures;
  for (const int index : {4, 1}) {
    ASSERT_TRUE(backwards.show(index));
    pictures.push_back(backwards.picture(cameras[0], size));
  }
  SequenceRenderer fresh(*reader, 4);
  ASSERT_TRUE(fresh.show(1));
  EXPECT_EQ(fresh.picture(cameras[0], size).rgb, pictures[1].rgb);
  EXPECT_NE(pictures[0].rgb, pictures[1].rgb);
}

}  // namespace ribbon::sequence_renderer_test

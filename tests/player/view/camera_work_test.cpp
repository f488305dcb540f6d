#include "player/view/camera_work.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "inspection/looped_ribbon.h"
#include "recording/sample_recording.h"

namespace ribbon::camera_work_test {

constexpr PictureSize wide{1280, 720};

RecordingReader recorded(int frames) {
  const std::filesystem::path path = temporary_file("shot.rbn");
  write_sample_recording(path, frames);
  return RecordingReader::open(path).value();
}

// How near anything of the sample comes to the border of the picture: 1 is the border.
float widest(const Camera& camera, int frames) {
  float widest = 0;
  const auto include = [&](const Eigen::Matrix3Xf& points) {
    for (const auto point : points.colwise()) {
      const Eigen::Vector3f seen = camera.project(point);
      EXPECT_GT(seen.z(), 0);
      widest = std::max(widest, seen.head<2>().cwiseAbs().maxCoeff());
    }
  };
  for (int frame = 0; frame < frames; ++frame) include(sample_positions(frame).cast<float>());
  include(sample_header().obstacle->vertices);
  return widest;
}

TEST(CameraWork, a_still_camera_sees_every_particle_of_every_frame_and_the_obstacle) {
  RecordingReader reader = recorded(12);
  const CameraWork work(reader, {{three_quarter_view, wide}, {front_view, {420, 320}}});
  for (const std::size_t shot : {0, 1}) EXPECT_LT(widest(work.camera(shot, {3}), 12), 0.93F);
  EXPECT_EQ(work.camera(0, {3}).eye, work.camera(0, {11, 0.5}).eye);
}

TEST(CameraWork, a_turning_camera_goes_round_once_and_sees_everything_all_the_way) {
  RecordingReader reader = recorded(12);
  const CameraWork work(reader, {{three_quarter_view, wide, 1}});
  const Eigen::Vector3f start = work.camera(0, {0, 0}).eye;
  EXPECT_LT((work.camera(0, {0, 1}).eye - start).norm(), 1e-3F * start.norm());
  EXPECT_GT((work.camera(0, {0, 0.5}).eye - start).norm(), 0.5F * start.norm());
  for (int step = 0; step < 20; ++step)
    EXPECT_LT(widest(work.camera(0, {0, 0.05 * step}), 12), 0.94F) << step;
}

TEST(CameraWork, a_distance_and_a_lens_are_kept) {
  RecordingReader reader = recorded(3);
  View view = front_view;
  view.distance_m = 2;
  View longer = view;
  longer.lens_mm = 2 * view.lens_mm;
  const CameraWork work(reader, {{view, wide}, {longer, wide}});
  EXPECT_EQ(work.camera(0, {}).eye, work.camera(1, {}).eye);
  EXPECT_FLOAT_EQ(work.camera(0, {}).half_width, 2 * work.camera(1, {}).half_width);
  Camera level = work.camera(0, {});
  const Eigen::Vector3f middle = level.eye - 2 * level.world_from_camera.col(2);
  EXPECT_LT(level.project(middle).head<2>().norm(), 1e-5F);
}

// A loop of two seconds; then the band, straight again, is elsewhere, or where it was.
TEST(CameraWork, a_knot_that_has_come_apart_and_left_is_not_looked_for_where_it_was) {
  const auto seen_at_last = [](double height_m) {
    const RecordingHeader header = header_with_post();
    std::vector<Pose> poses(100);
    poses.resize(200, Pose{.height_m = height_m, .turns = 0});
    auto reader = RecordingReader::open(record_loops(header, poses)).value();
    const Camera camera = CameraWork(reader, {{knot_view, wide}}).camera(0, {199});
    int inside = 0;
    const Eigen::Matrix3Xf last = looped_ribbon(header, poses.back()).cast<float>();
    for (const auto point : last.colwise())
      inside += camera.project(point).head<2>().cwiseAbs().maxCoeff() < 1 ? 1 : 0;
    return static_cast<double>(inside) / header.grid.particle_count();
  };
  EXPECT_EQ(seen_at_last(1.5), 1);
  EXPECT_GT(seen_at_last(0), 0.1) << "what is left of it";
  EXPECT_LT(seen_at_last(0), 0.9) << "from near";
}

TEST(CameraWork, keyframes_lead_the_camera) {
  RecordingReader reader = recorded(12);
  const double second = reader.header().frames_per_second;
  const std::string table =
      "time,azimuth,distance,x,y,z\n0,0,3,1,2,3\n" + std::to_string(10 / second) + ",90,5,1,2,3\n";
  Shot shot{View{0, 0}, wide};
  shot.path = CameraPath::parse(table, "keys.csv", shot.view).value();
  const CameraWork work(reader, {shot});
  EXPECT_LT((work.camera(0, {0}).eye - Eigen::Vector3f(1, 2, 6)).norm(), 1e-5F);
  EXPECT_LT((work.camera(0, {11}).eye - Eigen::Vector3f(6, 2, 3)).norm(), 1e-5F);
}

}  // namespace ribbon::camera_work_test

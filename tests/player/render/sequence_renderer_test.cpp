#include "player/render/sequence_renderer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "player/view/camera_work.h"
#include "recording/sample_recording.h"

namespace ribbon::sequence_renderer_test {

std::filesystem::path recorded(int frames) {
  std::filesystem::path path = temporary_file("shown.rbn");
  write_sample_recording(path, frames);
  return path;
}

TEST(SequenceRenderer, a_frame_looks_the_same_whatever_was_shown_before) {
  auto reader = RecordingReader::open(recorded(5));
  ASSERT_TRUE(reader) << reader.error().sentence();
  const PictureSize size{160, 90};
  const Camera camera = CameraWork(*reader, {{three_quarter_view, size}}).camera(0, {});
  SequenceRenderer backwards(*reader, RenderSettings{});
  std::vector<Picture> pictures;
  for (const int index : {4, 1}) {
    ASSERT_TRUE(backwards.show(index));
    pictures.push_back(backwards.picture(camera, size));
  }
  SequenceRenderer fresh(*reader, RenderSettings{});
  ASSERT_TRUE(fresh.show(1));
  EXPECT_EQ(fresh.picture(camera, size).rgb, pictures[1].rgb);
  EXPECT_NE(pictures[0].rgb, pictures[1].rgb);
}

// Two layers that come nearer from the side and lie in the same place at last.
std::filesystem::path recorded_meeting(int frames) {
  const RibbonGrid grid{60, 8};
  std::vector<Eigen::Matrix3Xd> meeting;
  for (int frame = 0; frame < frames; ++frame) {
    const double apart = 0.05 * (frames - 1 - frame);
    Eigen::Matrix3Xd positions(3, grid.particle_count());
    for (int p = 0; p < grid.particle_count(); ++p) {
      const bool is_upper = grid.row(p) >= 30;
      positions.col(p) << grid.row(p) % 30 / 30.0 + (is_upper ? apart : 0), 0.1 * grid.column(p),
          is_upper ? apart : 0;
    }
    meeting.push_back(std::move(positions));
  }
  std::filesystem::path path = temporary_file("meeting.rbn");
  write_recording(path, sample_header(grid), meeting, Ending::finished);
  return path;
}

// What rays from above meet, of triangles that lie in the same place.
std::vector<std::uint32_t> met_from_above(const SequenceRenderer& renderer) {
  std::vector<std::uint32_t> met;
  for (int row = 0; row < 32; ++row) {
    RayBatch rays;
    for (int column = 0; column < 32; ++column)
      rays.add(
          {{0.01F + 0.03F * static_cast<float>(column), 0.01F + 0.02F * static_cast<float>(row), 2},
           {0, 0, -1}});
    HitBatch hits;
    renderer.scene().rays().first_hits(rays, Coherence::mixed, hits);
    for (std::size_t lane = 0; lane < rays.count; ++lane)
      met.push_back(hits.body[lane] == Body::none ? ~0U : hits.triangle[lane]);
  }
  return met;
}

// The tree settles which of them is met.
TEST(SequenceRenderer, rays_meet_the_same_triangles_whatever_was_shown_before) {
  auto reader = RecordingReader::open(recorded_meeting(21));
  ASSERT_TRUE(reader) << reader.error().sentence();
  for (const char* quality : {"draft", "standard", "final"}) {
    const auto met_after = [&](const std::vector<int>& shown) {
      SequenceRenderer renderer(*reader, {*quality_named(quality), {}, {}});
      for (const int index : shown) EXPECT_TRUE(renderer.show(index));
      EXPECT_TRUE(renderer.show(20));
      return met_from_above(renderer);
    };
    const auto fresh = met_after({});
    EXPECT_EQ(met_after({0, 1, 2, 9}), fresh) << quality;
    EXPECT_EQ(met_after({19}), fresh) << quality;
    EXPECT_EQ(met_after({20, 3}), fresh) << quality;
  }
}

TEST(FrameOfTree, depends_on_the_frame_alone) {
  const Quality draft = *quality_named("draft");
  const Quality standard = *quality_named("standard");
  const Quality final = *quality_named("final");
  EXPECT_EQ(frame_of_tree(0, draft), 0);
  EXPECT_EQ(frame_of_tree(63, draft), 0);
  EXPECT_EQ(frame_of_tree(64, draft), 64);
  EXPECT_EQ(frame_of_tree(7, standard), 0);
  EXPECT_EQ(frame_of_tree(17, standard), 16);
  EXPECT_EQ(frame_of_tree(17, final), 17);
}

}  // namespace ribbon::sequence_renderer_test

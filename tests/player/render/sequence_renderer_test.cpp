#include "player/render/sequence_renderer.h"

#include <gtest/gtest.h>

#include <filesystem>

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

// How near a tie between two triangles is settled depends on the tree.
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

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

}  // namespace ribbon::sequence_renderer_test

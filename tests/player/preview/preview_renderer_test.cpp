#include "player/preview/preview_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "player/render/sequence_renderer.h"
#include "player/view/camera_work.h"
#include "recording/sample_recording.h"

namespace ribbon::preview_renderer_test {

constexpr PictureSize size{320, 240};

// Two frames of a ribbon that is twisted farther in the second; with what the header has left.
RecordingReader recorded(const std::function<void(RecordingHeader&)>& change) {
  RecordingHeader header = sample_header();
  change(header);
  const auto path = temporary_file("previewed.rbn");
  std::filesystem::remove(path);
  write_recording(path, header, {sample_positions(40), sample_positions(70)}, Ending::finished);
  return RecordingReader::open(path).value();
}

void leave_the_ribbon(RecordingHeader& header) {
  header.obstacle.reset();
  header.input_curve.resize(3, 0);
}

Camera camera_of(RecordingReader& reader) {
  return CameraWork(reader, {{three_quarter_view, size}}).camera(0, {});
}

Picture preview(RecordingReader& reader, int frame, const PreviewSettings& settings = {}) {
  auto renderer = PreviewRenderer::create(reader, settings).value();
  EXPECT_TRUE(renderer.show(frame).has_value());
  return renderer.picture(camera_of(reader), size).value();
}

// Is something before the backdrop, which the first pixel of the row shows?
bool is_covered(const Picture& picture, std::size_t at) {
  const std::size_t row = 3 * static_cast<std::size_t>(picture.size.width);
  for (std::size_t channel = 0; channel < 3; ++channel)
    if (std::abs(picture.rgb[at + channel] - picture.rgb[at / row * row + channel]) > 16)
      return true;
  return false;
}

// Of the backdrop alone the three channels are nearly alike.
bool is_coloured(const std::uint8_t* rgb) {
  return std::max({rgb[0], rgb[1], rgb[2]}) - std::min({rgb[0], rgb[1], rgb[2]}) > 24;
}

int count_pixels(const Picture& picture, const std::function<bool(const std::uint8_t*)>& counts) {
  int count = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
    if (counts(picture.rgb.data() + i)) ++count;
  return count;
}

bool is_magenta(const std::uint8_t* rgb) {
  return rgb[0] > 200 && rgb[1] < 100 && rgb[2] > 100;
}

bool is_dark_grey(const std::uint8_t* rgb) {
  return !is_coloured(rgb) && rgb[1] < 170;
}

// An OpenGL that is not the right one draws nothing, and tells of no error.
TEST(PreviewRenderer, something_is_drawn) {
  RecordingReader reader = recorded(leave_the_ribbon);
  for (const bool antialiased : {false, true})
    EXPECT_GT(count_pixels(preview(reader, 0, {.antialiased = antialiased}), is_coloured), 2000);
}

TEST(PreviewRenderer, the_ribbon_is_seen_where_the_ray_tracer_sees_it_from_the_same_side) {
  RecordingReader reader = recorded(leave_the_ribbon);
  for (const int frame : {0, 1}) {
    const Picture drawn = preview(reader, frame);
    RenderSettings fine;
    fine.quality.samples = 16;
    SequenceRenderer ray_tracer(reader, fine);
    ASSERT_TRUE(ray_tracer.show(frame));
    const Picture traced = ray_tracer.picture(camera_of(reader), size);
    int outline = 0;  // pixels where one shows the ribbon and the other the backdrop
    int side = 0;     // where one shows its red back and the other its blue front
    const auto is_red = [](const std::uint8_t* rgb) { return rgb[0] > rgb[2] + 60; };
    const auto is_blue = [](const std::uint8_t* rgb) { return rgb[2] > rgb[0] + 60; };
    for (std::size_t i = 0; i < drawn.rgb.size(); i += 3) {
      const std::uint8_t* a = drawn.rgb.data() + i;
      const std::uint8_t* b = traced.rgb.data() + i;
      if (is_covered(drawn, i) != is_covered(traced, i)) ++outline;
      if ((is_red(a) && is_blue(b)) || (is_blue(a) && is_red(b))) ++side;
    }
    EXPECT_LT(outline, size.pixel_count() / 100) << frame;
    EXPECT_LT(side, 10) << frame;
    EXPECT_GT(count_pixels(drawn, is_red), 300) << frame;
    EXPECT_GT(count_pixels(drawn, is_blue), 300) << frame;
  }
}

TEST(PreviewRenderer, the_obstacle_is_lines_that_one_sees_through) {
  RecordingReader with = recorded([](auto& header) { header.input_curve.resize(3, 0); });
  RecordingReader without = recorded(leave_the_ribbon);
  const int lines = count_pixels(preview(with, 0), is_dark_grey) -
                    count_pixels(preview(without, 0), is_dark_grey);
  EXPECT_GT(lines, 100);
  EXPECT_LT(lines, 1500);
}

TEST(PreviewRenderer, the_input_curve_is_highlighted_where_the_recording_has_it) {
  RecordingReader with = recorded([](auto& header) { header.obstacle.reset(); });
  RecordingReader without = recorded(leave_the_ribbon);
  EXPECT_GT(count_pixels(preview(with, 0), is_magenta), 100);
  EXPECT_EQ(count_pixels(preview(without, 0), is_magenta), 0);
}

TEST(PreviewRenderer, what_the_ribbon_hides_of_the_curve_is_dimmed) {
  // A line right through the ribbon, from far behind it to far before it.
  RecordingReader reader = recorded([](auto& header) {
    leave_the_ribbon(header);
    header.input_curve.resize(3, 2);
    header.input_curve << 0, 0, 0.3F, 0.3F, -0.4F, 0.4F;
  });
  const auto is_dimmed = [](const std::uint8_t* rgb) {
    return rgb[0] > rgb[1] + 30 && rgb[2] > rgb[1] + 20 && !is_magenta(rgb);
  };
  const Picture picture = preview(reader, 0, {.antialiased = false});
  EXPECT_GT(count_pixels(picture, is_magenta), 50);
  EXPECT_GT(count_pixels(picture, is_dimmed), 10);
}

TEST(PreviewRenderer, a_frame_looks_the_same_whatever_was_drawn_before) {
  RecordingReader reader = recorded([](auto&) {});
  auto renderer = PreviewRenderer::create(reader, {}).value();
  const Camera camera = camera_of(reader);
  ASSERT_TRUE(renderer.show(1));
  const Picture second = renderer.picture(camera, size).value();
  ASSERT_TRUE(renderer.picture(camera, {97, 33}).has_value());
  ASSERT_TRUE(renderer.show(0));
  EXPECT_NE(renderer.picture(camera, size).value().rgb, second.rgb);
  ASSERT_TRUE(renderer.show(1));
  EXPECT_EQ(renderer.picture(camera, size).value().rgb, second.rgb);
}

// Pictures of more than 2048 pixels are drawn in parts.
TEST(PreviewRenderer, a_large_picture_has_no_seams) {
  RecordingReader reader = recorded([](auto&) {});
  auto renderer = PreviewRenderer::create(reader, {.antialiased = false}).value();
  ASSERT_TRUE(renderer.show(0));
  const Camera wide = CameraWork(reader, {{three_quarter_view, {4096, 64}}}).camera(0, {});
  const Picture picture = renderer.picture(wide, {4096, 64}).value();
  // What lies about the seam, drawn in one part.
  Camera narrow = wide;
  narrow.half_width /= 2;
  const Picture middle = renderer.picture(narrow, {2048, 64}).value();
  int different = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 2048; ++x)
      if (std::abs(picture.pixel(1024 + x, y)[0] - middle.pixel(x, y)[0]) > 16) ++different;
  EXPECT_LT(different, 2048 * 64 / 200);
  EXPECT_GT(count_pixels(middle, is_coloured), 200);
}

}  // namespace ribbon::preview_renderer_test

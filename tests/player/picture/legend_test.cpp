#include "player/picture/legend.h"

#include <gtest/gtest.h>

namespace ribbon::legend_test {

Legend legend_of(bool fields) {
  return {"strain, %", sequential_map(), {{0, "0"}, {0.5F, "4"}, {1, "8"}}, fields};
}

// The row of the picture that the bar covers the middle of, found by its first colour.
struct Bar {
  int left = -1;
  int right = -1;  // of the last pixel
  int row = 0;
};

Bar find_bar(const Picture& picture, const Color& first, const Color& last) {
  const auto from = srgb_bytes(first);
  const auto to = srgb_bytes(last);
  Bar bar;
  for (int y = 0; y < picture.size.height; ++y)
    for (int x = 0; x < picture.size.width; ++x) {
      const std::uint8_t* rgb = picture.pixel(x, y);
      if (bar.left < 0 && std::equal(from.begin(), from.end(), rgb)) bar = {x, x, y};
      if (y == bar.row && std::equal(to.begin(), to.end(), rgb)) bar.right = x;
    }
  return bar;
}

TEST(Legend, its_bar_shows_the_map_from_end_to_end) {
  const Legend legend = legend_of(false);
  Picture picture = blank_picture({640, 360}, Color(0.5F, 0.5F, 0.5F));
  draw_corner_legend(legend, CaptionPainter(), picture);
  const int width = 18 * picture_text_height(picture.size);
  const float half_pixel = 0.5F / static_cast<float>(width);
  const Bar bar = find_bar(picture, legend.map.at(half_pixel), legend.map.at(1 - half_pixel));
  ASSERT_GE(bar.left, 0);
  EXPECT_EQ(bar.right - bar.left + 1, width);
  for (int x = bar.left; x <= bar.right; x += 7) {
    const auto place = (static_cast<float>(x - bar.left) + 0.5F) / static_cast<float>(width);
    const auto expected = srgb_bytes(legend.map.at(place));
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), picture.pixel(x, bar.row))) << x;
  }
}

TEST(Legend, fields_have_the_colour_of_their_mark) {
  const Legend legend = legend_of(true);
  Picture picture = blank_picture({640, 360}, Color(0.5F, 0.5F, 0.5F));
  draw_corner_legend(legend, CaptionPainter(), picture);
  const int width = 18 * picture_text_height(picture.size);
  const Bar bar = find_bar(picture, legend.map.at(0), legend.map.at(1));
  ASSERT_GE(bar.left, 0);
  EXPECT_EQ(bar.right - bar.left + 1, width);
  const auto middle = srgb_bytes(legend.map.at(0.5F));
  for (const int x : {bar.left + width * 4 / 10, bar.left + width / 2})
    EXPECT_TRUE(std::equal(middle.begin(), middle.end(), picture.pixel(x, bar.row)));
}

TEST(Legend, stays_in_the_smallest_picture_and_out_of_the_rest_of_large_ones) {
  Picture small = blank_picture({16, 16}, Color(0, 0, 0));
  draw_corner_legend(legend_of(false), CaptionPainter(), small);
  Picture large = blank_picture({1280, 720}, Color(0, 0, 0));
  draw_corner_legend(legend_of(false), CaptionPainter(), large);
  for (int y = 0; y < 720; ++y)
    for (int x = 0; x < 1280; ++x)
      if (y < 600 || x > 400) {
        EXPECT_EQ(*large.pixel(x, y), 0);
      }
}

// How many pixels differ in the columns from left to right.
int differing(const Picture& a, const Picture& b, int left, int right) {
  int count = 0;
  for (int y = 0; y < a.size.height; ++y)
    for (int x = left; x < right; ++x)
      count += std::equal(a.pixel(x, y), a.pixel(x, y) + 3, b.pixel(x, y)) ? 0 : 1;
  return count;
}

Picture drawn(const std::vector<LegendMark>& marks) {
  Picture picture = blank_picture({640, 360}, Color(1, 1, 1));
  draw_legend({"gap", sequential_map(), marks}, 100, 100, 15, CaptionPainter(), picture);
  return picture;
}

TEST(Legend, inner_marks_that_would_touch_others_are_left_out) {
  const LegendMark low{0, "0"};
  const LegendMark high{1, "≥ 0.00074"};
  const Picture ends = drawn({low, high});
  EXPECT_EQ(differing(drawn({low, {0.8F, "0.0006"}, high}), ends, 0, 640), 0) << "touches the end";
  EXPECT_EQ(differing(drawn({low, {0.05F, "0.0001"}, high}), ends, 0, 640), 0);
  const Picture one = drawn({low, {0.3F, "0.0002"}, high});
  EXPECT_GT(differing(one, ends, 0, 640), 0);
  EXPECT_EQ(differing(drawn({low, {0.3F, "0.0002"}, {0.4F, "0.0003"}, high}), one, 0, 640), 0);
  EXPECT_GT(differing(drawn({low, {0.25F, "2"}, {0.4F, "3"}, {0.55F, "4"}, high}),
                      drawn({low, {0.25F, "2"}, {0.55F, "4"}, high}), 0, 640),
            0);
}

TEST(Legend, long_marks_stay_on_it) {
  const Picture blank = blank_picture({640, 360}, Color(1, 1, 1));
  const Picture picture = drawn({{0, "≤ 1.25e-06"}, {1, "≥ 1.86e+05"}});
  EXPECT_EQ(differing(picture, blank, 0, 100), 0);
  EXPECT_EQ(differing(picture, blank, 100 + legend_size(15).width, 640), 0);
}

}  // namespace ribbon::legend_test

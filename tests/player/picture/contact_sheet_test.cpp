#include "player/picture/contact_sheet.h"

#include <gtest/gtest.h>

namespace ribbon::contact_sheet_test {

SheetColumn column(int frame, const Color& upper, const Color& lower) {
  return {frame, {}, {blank_picture(sheet_cell, upper), blank_picture(sheet_cell, lower)}};
}

// Rows and columns of pixels that are purely of one channel.
int pure_pixels(const Picture& picture, int channel) {
  int count = 0;
  for (int y = 0; y < picture.size.height; ++y)
    for (int x = 0; x < picture.size.width; ++x) {
      const std::uint8_t* rgb = picture.pixel(x, y);
      const bool pure =
          rgb[channel] == 255 && rgb[(channel + 1) % 3] == 0 && rgb[(channel + 2) % 3] == 0;
      count += pure ? 1 : 0;
    }
  return count;
}

TEST(ContactSheet, every_picture_is_on_it_whole) {
  const Color red(1, 0, 0);
  const Color green(0, 1, 0);
  const Color blue(0, 0, 1);
  const Picture sheet =
      contact_sheet("title", "subtitle", {column(1, red, green), column(9, blue, green)});
  const auto cell = static_cast<int>(sheet_cell.pixel_count());
  EXPECT_EQ(pure_pixels(sheet, 0), cell);
  EXPECT_EQ(pure_pixels(sheet, 1), 2 * cell);
  EXPECT_EQ(pure_pixels(sheet, 2), cell);
  EXPECT_GT(sheet.size.width, 2 * sheet_cell.width);
  EXPECT_GT(sheet.size.height, 2 * sheet_cell.height);
}

TEST(ContactSheet, words_stay_in_their_column_and_clear_of_margin_and_legend) {
  const Color red(1, 0, 0);
  const std::string words =
      "the left end is laid over the knot and led round behind the post, then both are pulled "
      "until "
      "nothing gives way any more, and hang";
  SheetColumn first = column(1, red, red);
  first.stage = words;
  const Legend legend{"gap", sequential_map(), {{0, "0"}, {1, "9"}}};
  const auto with = [&](const std::vector<SheetColumn>& columns, const std::string& title) {
    return contact_sheet(title, title, columns, legend);
  };
  const auto differ_between = [](const Picture& a, const Picture& b, int left, int right) {
    int count = 0;
    for (int y = 0; y < a.size.height; ++y)
      for (int x = left; x < right; ++x)
        count += std::equal(a.pixel(x, y), a.pixel(x, y) + 3, b.pixel(x, y)) ? 0 : 1;
    return count;
  };
  const std::vector<SheetColumn> plain{column(1, red, red), column(1, red, red)};
  const Picture without_words = with(plain, "");
  const Picture told = with({first, plain[1]}, "");
  const int end_of_first = 24 + sheet_cell.width;
  EXPECT_GT(differ_between(told, without_words, 0, end_of_first), 0);
  EXPECT_EQ(differ_between(told, without_words, end_of_first, told.size.width), 0);
  const Picture titled = with({plain[0]}, words);
  const int begin_of_legend = titled.size.width - 24 - legend_size(15).width;
  const Picture untitled = with({plain[0]}, "");
  EXPECT_GT(differ_between(titled, untitled, 0, begin_of_legend), 0);
  EXPECT_EQ(differ_between(titled, untitled, begin_of_legend, titled.size.width), 0);
}

TEST(ContactSheet, captions_tell_frame_time_strain_and_penetrations) {
  EXPECT_EQ(sheet_caption(12, {0.4, 0.0412, 3, 5}),
            (std::vector<std::string>{"frame 12 · 0.40 s", "strain 4.1 % · 3 penetrations"}));
  EXPECT_EQ(sheet_caption(12, {0.4, 0, 0, 0}, "bow")[0], "frame 12 · 0.40 s · bow");
  EXPECT_EQ(sheet_caption(1, {0, 0, 1, 0})[1], "strain 0.0 % · 1 penetration");
}

TEST(ContactSheet, frames_are_spread_evenly_with_both_ends) {
  EXPECT_EQ(spread_frames({4, 5, 6}, 6), (std::vector<int>{4, 5, 6}));
  EXPECT_EQ(spread_frames({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 6),
            (std::vector<int>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(spread_frames({9, 8, 7}, 2), (std::vector<int>{9, 7}));
}

}  // namespace ribbon::contact_sheet_test

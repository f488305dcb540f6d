#include "player/picture/picture.h"

#include <gtest/gtest.h>

namespace ribbon::picture_test {

TEST(Picture, encoding_srgb_treats_each_channel_alike) {
  const LightPicture light{{2, 1}, {Color(0, 0.5F, 1), Color(1, 0, 0.5F)}};
  const Picture picture = encode_srgb(light);
  EXPECT_EQ(picture.rgb, (std::vector<std::uint8_t>{0, 188, 255, 255, 0, 188}));
}

TEST(Picture, pasting_touches_only_its_place) {
  Picture target = blank_picture({4, 3}, Color(0, 0, 0));
  paste(blank_picture({2, 1}, Color(1, 1, 1)), 1, 2, target);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      EXPECT_EQ(*target.pixel(x, y), y == 2 && (x == 1 || x == 2) ? 255 : 0) << x << "," << y;
}

TEST(Picture, filling_lays_a_colour_over_what_is_inside) {
  Picture target = blank_picture({4, 3}, Color(0, 0, 0));
  fill({2, -5, 9, 2}, Color(1, 1, 1), 0.4F, target);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      EXPECT_EQ(*target.pixel(x, y), y < 2 && x >= 2 ? 102 : 0) << x << "," << y;
}

}  // namespace ribbon::picture_test

#include "player/view/view.h"

#include <gtest/gtest.h>

#include "result/refusal.h"

namespace ribbon::view_test {

TEST(View, names_stand_for_views) {
  EXPECT_EQ(parse_view("front").value(), front_view);
  EXPECT_EQ(parse_view("top").value(), top_view);
  EXPECT_EQ(parse_view("three-quarter").value(), three_quarter_view);
  EXPECT_EQ(parse_view("knot").value(), knot_view);
}

TEST(View, settings_change_the_three_quarter_view) {
  const View view = parse_view("azimuth=-30.5,distance=2,lens=85,subject=knot").value();
  EXPECT_EQ(view, (View{-30.5F, three_quarter_view.elevation_deg, Subject::knot, 2, 85}));
}

TEST(View, what_makes_no_view_is_refused_with_what_does) {
  for (const char* text : {"", "side", "azimuth", "azimuth=", "azimuth=3x", "azimuth=nan",
                           "elevation=91", "distance=0", "distance=-1", "lens=0", "tilt=3",
                           "azimuth=3,,lens=60", "azimuth=3 lens=60", "subject=bow", "front,knot"})
    EXPECT_THAT(refusal_of(parse_view(text)), HasSubstr("; write ")) << text;
}

TEST(View, a_setting_is_given_once) {
  EXPECT_THAT(refusal_of(parse_view("azimuth=1,lens=60,azimuth=2")),
              HasSubstr("sets azimuth twice; write it once"));
  EXPECT_THAT(refusal_of(parse_view("subject=knot,subject=knot")), HasSubstr("subject twice"));
}

TEST(View, several_get_names_for_their_files) {
  const auto views = parse_views({"knot", "azimuth=10", "azimuth=20"}).value();
  ASSERT_EQ(views.size(), 3U);
  EXPECT_EQ(views[0].name, "knot");
  EXPECT_EQ(views[1].name, "camera1");
  EXPECT_EQ(views[2].name, "camera2");
  EXPECT_THAT(refusal_of(parse_views({"top", "top"})), HasSubstr("twice"));
}

}  // namespace ribbon::view_test

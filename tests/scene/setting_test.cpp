#include "scene/setting.h"

#include <gtest/gtest.h>

#include "result/refusal.h"
#include "scene/scene.h"
#include "scene/scene_files.h"

namespace ribbon::with_setting_test {

const std::string commented =
    "# Über the hourglass\n"
    "name = \"knot\"\n"
    "[curve]\npoints = [[0, 0], [100, 50]]\n"
    "[ribbon]\nwidth = 0.05  # wide\nalong = 40\nacross = 4\n"
    "[air]  # still\nresistance = 10\n"
    "[time]\nduration = 4\nuntil = \"duration\"  # ä\n";

std::string changed(const std::string& text, const std::string& setting) {
  return with_setting("knot.toml", text, setting).value();
}

std::string refused(const std::string& text, const std::string& setting) {
  return refusal_of(with_setting("knot.toml", text, setting));
}

TEST(WithSetting, changes_a_value_where_it_stands_and_nothing_else) {
  EXPECT_EQ(changed(commented, "ribbon.width=0.25"), replaced(commented, "0.05", "0.25"));
  EXPECT_EQ(changed(commented, " time.duration = 400 "), replaced(commented, "= 4\nu", "= 400\nu"));
  EXPECT_EQ(changed(commented, "name=Überhand"), replaced(commented, "\"knot\"", "\"Überhand\""));
  EXPECT_EQ(changed(commented, "curve.points=[[1, 2], [3, 4]]"),
            replaced(commented, "[[0, 0], [100, 50]]", "[[1, 2], [3, 4]]"));
}

TEST(WithSetting, a_word_needs_no_quotes) {
  EXPECT_EQ(changed(commented, "time.until=tight"),
            replaced(commented, "\"duration\"", "\"tight\""));
  EXPECT_EQ(changed(commented, "time.until=\"tight\""), changed(commented, "time.until=tight"));
}

TEST(WithSetting, adds_what_is_missing_to_its_table) {
  EXPECT_EQ(changed(commented, "air.other=1"),
            replaced(commented, "[air]  # still\n", "[air]  # still\nother = 1\n"));
  EXPECT_EQ(changed(commented, "accuracy=fine"), "accuracy = \"fine\"\n" + commented);
  EXPECT_EQ(changed(commented, "springs.stretch=40"), commented + "\n[springs]\nstretch = 40\n");
  EXPECT_EQ(changed("[ribbon]", "ribbon.width=1"), "[ribbon]\nwidth = 1\n");
}

TEST(WithSetting, leaves_a_byte_order_mark_in_front) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(changed(mark + "name = 'x'\n", "name=xyz"), mark + "name = \"xyz\"\n");
  EXPECT_EQ(changed(mark + commented, "accuracy=fine"), mark + "accuracy = \"fine\"\n" + commented);
}

TEST(WithSetting, finds_values_however_tables_are_written) {
  EXPECT_EQ(changed("ribbon.width = 1\n", "ribbon.width=2"), "ribbon.width = 2\n");
  EXPECT_EQ(changed("ribbon = { width = 1, along = 4 }\n", "ribbon.width=2"),
            "ribbon = { width = 2, along = 4 }\n");
}

TEST(WithSetting, the_scene_says_whether_it_knows_the_key_and_the_value) {
  EXPECT_THAT(refusal_of(read_scene("knot.toml", changed(commented, "ribbon.widht=2"))),
              HasSubstr("did you mean 'width'?"));
  EXPECT_THAT(refusal_of(read_scene("knot.toml", changed(commented, "ribbon.width=-2"))),
              HasSubstr("'width' must be"));
  EXPECT_EQ(read_scene("knot.toml", changed(commented, "ribbon.width=2"))->ribbon.width_m, 2);
}

// The mesh stands on line 8 and stays there, whatever settings write above it or below.
TEST(ReadScene, with_settings_places_are_those_of_the_file_or_the_setting) {
  const std::string text =
      "[curve]\npoints = [[0, 0], [100, 50]]\n[ribbon]\nalong = 40\nacross = 5\nwidth = 0.05\n"
      "[obstacle]\nmesh = 'ball.obj'\n[time]\nduration = 1";
  const auto place = [&](const std::vector<std::string>& settings) {
    return read_scene("knot.toml", text, settings).value().obstacle->file.place;
  };
  EXPECT_EQ(place({}), "knot.toml:8:8");
  for (const char* setting :
       {"accuracy=fine", "ribbon.along=100", "ribbon.across=9", "curve.points=[[0, 0], [1, 2]]",
        "time.step=0.001", "air.resistance=1"})
    EXPECT_EQ(place({setting}), "knot.toml:8:8") << setting;
  EXPECT_EQ(place({"accuracy=fine", "air.resistance=1", "obstacle.scale=2", "ribbon.along=100"}),
            "knot.toml:8:8");
  EXPECT_EQ(place({"accuracy=fine", "obstacle.mesh=box.obj", "name=box"}),
            "knot.toml with 'obstacle.mesh=box.obj'");
}

TEST(WithSetting, what_is_not_a_setting_is_refused) {
  for (const std::string setting :
       {"", "=", "width", "=3", "ribbon.=3", "ribbon.wi dth=3", "a.b.c=3",
        "ribbon.width=", "ribbon.width=a\"b", "ribbon.width=3\n[air]"})
    EXPECT_THAT(refused(commented, setting), HasSubstr("is not a setting")) << setting;
}

TEST(WithSetting, a_table_without_a_line_of_its_own_has_no_place_for_more) {
  EXPECT_THAT(refused("ribbon.width = 1\n", "ribbon.along=2"), HasSubstr("there is no place"))
      << changed("ribbon.width = 1\n", "ribbon.along=2");
}

TEST(ReadScene, without_loss_is_zero_alone) {
  const auto scene = [](const std::string& value) {
    return read_scene("knot.toml", changed(commented, "recording.max_position_error=" + value));
  };
  EXPECT_EQ(scene("0")->recording.max_position_error, 0);
  EXPECT_EQ(scene("0.0")->recording.max_position_error, 0);
  EXPECT_FALSE(scene("1e-9").has_value());
  EXPECT_FALSE(scene("-1e-5").has_value());
}

TEST(ReadScene, checkpoints_are_as_rare_as_10000_frames_unless_the_scene_says) {
  const auto every_s = [](const std::string& setting) {
    return read_scene("knot.toml", changed(commented, setting))->recording.checkpoint_every_s;
  };
  EXPECT_EQ(every_s("recording.frames_per_second=25"), 400);
  EXPECT_EQ(every_s("recording.checkpoint_every=0"), 0);
  EXPECT_EQ(every_s("recording.checkpoint_every=2.5"), 2.5);
}

std::string with_words(const std::string& text, const std::string& key, const std::string& words) {
  return with_entry_replaced("knot.toml", text, "ribbon", key, words).value();
}

TEST(WithEntryReplaced, leaves_all_else_on_its_line) {
  EXPECT_EQ(with_words(commented, "width", "mass = 3"),
            replaced(commented, "width = 0.05", "mass = 3"));
  EXPECT_EQ(with_words(commented, "width", ""), replaced(commented, "width = 0.05", ""));
  EXPECT_EQ(with_words(commented, "mass", "width = 3"), commented) << "there is no mass";
}

TEST(WithEntryReplaced, fails_where_no_toml_is_left) {
  EXPECT_THAT(refusal_of(with_entry_replaced("knot.toml", "ribbon = { width = 1, along = 4 }\n",
                                             "ribbon", "width", "")),
              HasSubstr("there is no place for 'width'"));
}

}  // namespace ribbon::with_setting_test

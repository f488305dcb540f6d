// A recording as a page: one file that holds all of it and loads nothing.
#include <gtest/gtest.h>

#include "page/base64.h"
#include "page/page_parts.h"
#include "page/seven_bits.h"
#include "page/unpacked.h"
#include "player/page/viewer_page.h"
#include "player/page/write_page.h"
#include "player/ribbon_play.h"

namespace ribbon::page_test {

// The reverse, for texts that are right.
std::string bytes_of(std::string_view text) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int waiting = 0;
  for (const char letter : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(letter));
    waiting += 6;
    if (waiting < 8) continue;
    waiting -= 8;
    bytes += static_cast<char>(bits >> waiting & 0xFFU);
  }
  return bytes;
}

TEST(Base64, is_that_of_the_standard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFB\xFF\xBF"), "+/+/");
}

TEST(SevenBits, say_the_bytes_and_nothing_that_a_page_changes) {
  std::string bytes;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = seven_bits(bytes);
    ASSERT_TRUE(bytes_of_seven_bits(text) == bytes) << i;
    for (const char letter : {'\0', '\r', '<', '{'})
      ASSERT_EQ(text.find(letter), std::string::npos);
    bytes += static_cast<char>(i * 31 % 256);
  }
  EXPECT_LT(seven_bits(bytes).size(), 1.2 * static_cast<double>(bytes.size()));
}

TEST(PageParts, are_texts_and_places_in_turn) {
  const auto parts = page_parts("a{{b}}{{c d}}e{{f");
  std::string told;
  for (const PagePart& part : parts)
    told += (part.is_place ? "<" : "") + std::string(part.text) + (part.is_place ? ">" : "|");
  EXPECT_EQ(told, "a|<b>|<c d>e{{f|");
}

TEST_F(RibbonPlay, pages_follow_no_option_of_pictures) {
  expect_refusal(play_small("-o knot.html --view knot"), "--size");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "knot.html"));
}

TEST_F(RibbonPlay, page_holds_the_recording_and_loads_nothing) {
  if (viewer_page().empty()) {
    expect_refusal(run("knot.rbn -o knot.html"), "built without Emscripten");
    return;
  }
  EXPECT_THAT(output_of(run("knot.rbn -o knot.html")), HasSubstr("page: "));
  const std::string page = bytes("knot.html");
  const std::size_t begin = page.find('>', page.find("id=\"recording\"")) + 1;
  EXPECT_EQ(bytes_of(page.substr(begin, page.find('<', begin) - begin)), bytes("knot.rbn"));
  EXPECT_LE(page.size(), 350'000 + (bytes("knot.rbn").size() + 2) / 3 * 4);
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  expect_refusal(run("knot.rbn -o knot.html"), "--force");
}

TEST_F(RibbonPlay, a_page_of_a_damaged_recording_is_answered_with_1_and_of_an_empty_one_refused) {
  if (viewer_page().empty()) GTEST_SKIP() << "built without Emscripten";
  damage();
  const ToolRun damaged = run("knot.rbn -o damaged.html");
  EXPECT_EQ(damaged.exit_code, 1);
  EXPECT_THAT(damaged.errors, HasSubstr("lost to damage and not rendered: frames "));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "damaged.html"));
  write_sample_recording(recording_, 0);
  expect_refusal(run("knot.rbn -o empty.html"), "holds no frames; record some first");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "empty.html"));
}

TEST_F(RibbonPlay, a_page_that_is_interrupted_leaves_nothing_and_asks_for_another_try) {
  if (viewer_page().empty()) GTEST_SKIP() << "built without Emscripten";
  const auto reader = RecordingReader::open(recording_).value();
  const auto written =
      write_page(reader, recording_, folder_ / "knot.html", Older::stays, [] { return true; });
  ASSERT_FALSE(written.has_value());
  EXPECT_TRUE(written.error().may_pass);
  EXPECT_THAT(written.error().sentence(), HasSubstr("interrupted at byte 0"));
  EXPECT_THAT(names("."), ElementsAre("knot.rbn"));
}

}  // namespace ribbon::page_test

// ribbon-record --draw: a page in which one draws.
#include "recorder/page/sketch_page.h"

#include <gtest/gtest.h>

#include "commandline/tool_run.h"
#include "page/unpacked.h"
#include "recorder/page/packed.h"
#include "recorder/small_scene.h"

namespace ribbon::sketch_page_test {

TEST(Packed, is_smaller_and_unpacked_as_it_was) {
  std::string bytes;
  for (int i = 0; i < 20000; ++i) bytes += static_cast<char>(i * i / 64 % 7 + i % 3);
  const std::string text = packed(bytes);
  EXPECT_LT(text.size(), bytes.size() / 2);
  EXPECT_TRUE(unpacked(text, bytes.size()) == bytes);
  EXPECT_EQ(unpacked(packed(""), 1), "");
}

class SketchPage : public ToolTest {
 protected:
  SketchPage() : ToolTest(RIBBON_RECORD) { write_small_scene(folder_); }
};

TEST_F(SketchPage, is_one_file_that_loads_nothing) {
  if (sketch_page().empty()) {
    expect_refusal(run("--draw -o sketch.html"), "built without Emscripten");
    return;
  }
  EXPECT_THAT(output_of(run("--draw -o sketch.html")), HasSubstr("page: sketch.html"));
  const std::string page = bytes("sketch.html");
  EXPECT_LE(page.size(), 1'000'000U);
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
  expect_refusal(run("--draw -o sketch.html"), "--force");
}

// As one that came meanwhile: a way through a folder that is yet to be created leads to it.
TEST_F(SketchPage, takes_no_place_of_a_file_that_is_met_only_in_the_end) {
  if (sketch_page().empty()) GTEST_SKIP() << "this build has no pages";
  ASSERT_TRUE(write_file(folder_ / "theirs", "somebody else's").has_value());
  expect_refusal(run("--draw -o new/../theirs"), "theirs: was put there by somebody else");
  EXPECT_EQ(bytes("theirs"), "somebody else's");
}

TEST_F(SketchPage, holds_the_scene_that_is_named) {
  if (sketch_page().empty()) GTEST_SKIP() << "this build has no pages";
  ASSERT_EQ(run("--draw small.toml --set name='</script>' -o sketch.html").exit_code, 0);
  const std::string page = bytes("sketch.html");
  const std::string begin = "id=\"scene\">";
  const std::size_t at = page.find(begin) + begin.size();
  const std::string scene = unpacked(page.substr(at, page.find('<', at) - at), 1 << 20);
  EXPECT_THAT(scene, HasSubstr("\"file\":\"small.toml\""));
  EXPECT_THAT(scene, HasSubstr("\"name\":\"</script>\""));
}

TEST_F(SketchPage, is_as_small_with_an_object_of_many_triangles) {
  if (sketch_page().empty()) GTEST_SKIP() << "this build has no pages";
  for (const std::string scene : {"overhand-hourglass-8x400", "gallery/obi"}) {
    ASSERT_EQ(run("--draw " RIBBON_SAMPLES "/" + scene + ".toml --force -o sketch.html").exit_code,
              0);
    EXPECT_LE(bytes("sketch.html").size(), 1'000'000U) << scene;
  }
}

TEST_F(SketchPage, goes_with_nothing_that_records) {
  expect_refusal(run("--draw"), "--draw needs a page to write");
  expect_refusal(run("--draw -o sketch.html --frames 3"), "records nothing");
  expect_refusal(run("--draw -o sketch.html --set ribbon.along=80"), "there is none");
  expect_refusal(run("--draw none.toml -o sketch.html"), "none.toml");
}

}  // namespace ribbon::sketch_page_test

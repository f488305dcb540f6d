// ribbon-record --draw: a page in which one draws.
#include "recorder/page/sketch_page.h"

#include <gtest/gtest.h>

#include "commandline/tool_run.h"
#include "recorder/small_scene.h"

namespace ribbon::sketch_page_test {

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

TEST_F(SketchPage, holds_the_scene_that_is_named) {
  if (sketch_page().empty()) GTEST_SKIP() << "this build has no pages";
  ASSERT_EQ(run("--draw small.toml --set name='</script>' -o sketch.html").exit_code, 0);
  const std::string page = bytes("sketch.html");
  EXPECT_THAT(page, HasSubstr("\"file\":\"small.toml\""));
  EXPECT_THAT(page, HasSubstr("\\u003c/script>"));
}

TEST_F(SketchPage, goes_with_nothing_that_records) {
  expect_refusal(run("--draw"), "--draw needs a page to write");
  expect_refusal(run("--draw -o sketch.html --frames 3"), "records nothing");
  expect_refusal(run("--draw -o sketch.html --set ribbon.along=80"), "there is none");
  expect_refusal(run("--draw none.toml -o sketch.html"), "none.toml");
}

}  // namespace ribbon::sketch_page_test

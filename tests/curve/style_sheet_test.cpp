#include "curve/style_sheet.h"

#include <gtest/gtest.h>

#include <string>

namespace ribbon {

// Of a <path class="a b" id="p">, whose style may be told.
std::string display_by(const std::string& css, const std::string& style = "") {
  return StyleSheet(css, {"display"})
      .value_of("display", {"path", "p", "a b", style})
      .value_or("untold");
}

TEST(StyleSheet, names_classes_and_ids_say_whom_a_rule_means) {
  for (const char* selector :
       {"path", "*", ".a", ".b", "#p", "path.a", ".b.a", "path#p.a", "*.a", "g, .a", " .c ,\n.b "})
    EXPECT_EQ(display_by(std::string(selector) + "{display:none}"), "none") << selector;
  for (const char* selector : {"g", ".c", "#q", "g.a", ".a.c", "path#q", ".A", "#a", ".p", "pat"})
    EXPECT_EQ(display_by(std::string(selector) + "{display:none}"), "untold") << selector;
}

TEST(StyleSheet, the_heaviest_says_and_of_equals_the_last) {
  EXPECT_EQ(display_by(".a{display:none} .b{display:inline}"), "inline");
  EXPECT_EQ(display_by(".a{display:none} path{display:inline}"), "none");
  EXPECT_EQ(display_by("#p{display:none} .a.b{display:inline}"), "none");
  EXPECT_EQ(display_by("path.a{display:none} .b{display:inline}"), "none");
  EXPECT_EQ(display_by(".a.b{display:none} path.b{display:inline}"), "none");
  EXPECT_EQ(display_by("#p{display:none}", "display:inline"), "inline");
  EXPECT_EQ(display_by(".a{display:none !important} #p{display:x}", "display:inline"), "none");
  EXPECT_EQ(display_by(".a{display:none!important}", "display : inline ! important"), "inline");
  EXPECT_EQ(display_by("", "display:none;display:inline"), "inline");
  EXPECT_EQ(display_by("", ";; display: NONE ;"), "none");
}

TEST(StyleSheet, what_drawing_programs_write_around_rules_does_not_matter) {
  EXPECT_EQ(display_by("<!-- /* .a{display:none} */ @charset \"utf-8;{\";\n"
                       "@font-face { font-family: 'x}'; src: url(data:a;b{c) }\n"
                       "@media print { .a { display: none } .b { } }\n"
                       ".st0{fill:url(#p;q);font-family:'it;{s';}\n.b {\tdisplay :\nInline;} -->"),
            "inline");
  for (const char* css : {"", "  ", ".a", ".a{", ".a{display", ".a{display:", "@media", "@media {",
                          "/* .a{display:none}", "}", "{", ";", ".a{display:;}", "@"})
    EXPECT_EQ(display_by(css), "untold") << css;
  EXPECT_EQ(display_by(".a{display:none"), "none");
}

TEST(StyleSheet, a_selector_that_is_not_followed_is_told_where_it_matters) {
  for (const char* selector :
       {"g > path", "g path", "path:first-child", "[id=x]", "a+path", "a ~path", ".", "path.", "#"})
    EXPECT_EQ(StyleSheet(std::string(selector) + "{display:none}", {"display"}).not_followed(),
              std::string(selector));
  EXPECT_EQ(StyleSheet(".a, g path{display:none}", {"display"}).not_followed(), "g path");
  EXPECT_EQ(StyleSheet(".a:hover, g:focus path{display:none}", {"display"}).not_followed(),
            std::nullopt);
  EXPECT_EQ(StyleSheet("g path{fill:none} .a{display:none}", {"display"}).not_followed(),
            std::nullopt);
}

}  // namespace ribbon

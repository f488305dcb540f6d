#include "curve/style_sheet.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace ribbon::style_sheet_test {

// <svg><g class="layer"><g id="band"> around it.
const StyledElement svg{"svg", "", "", "", nullptr};
const StyledElement layer{"g", "", "layer", "", [] { return std::optional(svg); }};
const StyledElement band{"g", "band", "", "", [] { return std::optional(layer); }};

// Of a <path class="a b" id="p"> in it, whose style may be told.
std::string display_by(const std::string& css, const std::string& style = "") {
  StyleSheet sheet({"display"});
  EXPECT_EQ(sheet.add(css), std::nullopt);
  return sheet.value_of("display", {"path", "p", "a b", style, [] { return std::optional(band); }})
      .value_or("untold");
}

std::optional<std::string> not_followed(const std::string& css) {
  return StyleSheet({"display"}).add(css);
}

TEST(StyleSheet, names_classes_and_ids_say_whom_a_rule_means) {
  for (const char* selector :
       {"path", "*", ".a", ".b", "#p", "path.a", ".b.a", "path#p.a", "*.a", "g, .a", " .c ,\n.b "})
    EXPECT_EQ(display_by(std::string(selector) + "{display:none}"), "none") << selector;
  for (const char* selector : {"g", ".c", "#q", "g.a", ".a.c", "path#q", ".A", "#a", ".p", "pat"})
    EXPECT_EQ(display_by(std::string(selector) + "{display:none}"), "untold") << selector;
}

TEST(StyleSheet, what_an_element_is_in_says_so_too) {
  for (const char* selector : {"g path", "svg path", "g > path", "#band>.a", "svg g path",
                               ".layer .b", "svg > g > g > path", ".layer > g path",
                               "svg .layer > #band > path", "g g > path", "svg * path"})
    EXPECT_EQ(display_by(std::string(selector) + "{display:none}"), "none") << selector;
  for (const char* selector :
       {"svg > path", ".layer > path", "path g", "g g g path", "#band svg path", "path path",
        "svg > #band path", ".layer > .a", "#band > g path"})
    EXPECT_EQ(display_by(std::string(selector) + "{display:none}"), "untold") << selector;
}

TEST(StyleSheet, the_heaviest_says_and_of_equals_the_last) {
  EXPECT_EQ(display_by(".a{display:none} .b{display:inline}"), "inline");
  EXPECT_EQ(display_by(".a{display:none} path{display:inline}"), "none");
  EXPECT_EQ(display_by("#p{display:none} .a.b{display:inline}"), "none");
  EXPECT_EQ(display_by("path.a{display:none} .b{display:inline}"), "none");
  EXPECT_EQ(display_by(".a.b{display:none} path.b{display:inline}"), "none");
  EXPECT_EQ(display_by("g path{display:none} path{display:inline}"), "none");
  EXPECT_EQ(display_by("#band path{display:none} .a.b{display:inline}"), "none");
  EXPECT_EQ(display_by("#p{display:none}", "display:inline"), "inline");
  EXPECT_EQ(display_by(".a{display:none !important} #p{display:x}", "display:inline"), "none");
  EXPECT_EQ(display_by(".a{display:none!important}", "display : inline ! important"), "inline");
  EXPECT_EQ(display_by("", "display:none;display:inline"), "inline");
  EXPECT_EQ(display_by("", ";; display: NONE ;"), "none");
  EXPECT_EQ(display_by("", R"(-inkscape-font-specification:'Children\'s Hand';display:none)"),
            "none");
}

TEST(StyleSheet, one_goes_on_behind_another_that_was_not_closed) {
  StyleSheet sheet({"display"});
  EXPECT_EQ(sheet.add(".a{display:none} .b{display:inline /* "), std::nullopt);
  EXPECT_EQ(sheet.add(".a{display:none}"), std::nullopt);
  EXPECT_EQ(sheet.value_of("display", {"path", "", "a b", "", nullptr}), "none");
}

TEST(StyleSheet, what_drawing_programs_write_around_rules_does_not_matter) {
  EXPECT_EQ(display_by("<!-- /* .a{display:none} */ @charset \"utf-8;{\";\n"
                       "@font-face { font-family: 'x}'; src: url(data:a;b{c) }\n"
                       "@media print { .a { display: none } .b { } }\n"
                       "@keyframes k { from { display: none } }\n"
                       "@media screen { .a { fill: none } }\n"
                       ".st0{fill:url(#p;q);font-family:'it;{s';}\n.b {\tdisplay :\nInline;} -->"),
            "inline");
  EXPECT_EQ(display_by(".t{font:'no end\n} .a{display:none}"), "none");
  for (const char* css : {"", "  ", ".a", ".a{", ".a{display", ".a{display:", "@media", "@media {",
                          "/* .a{display:none}", "}", "{", ";", ".a{display:;}", "@"})
    EXPECT_EQ(display_by(css), "untold") << css;
  EXPECT_EQ(display_by(".a{display:none"), "none");
}

TEST(StyleSheet, a_selector_that_is_not_followed_is_told_where_it_matters) {
  for (const char* selector : {"path:first-child", "[id=x]", "a+path", "a ~path", ".", "path.", "#",
                               "> path", "g > > path", "g >", "svg|path", "*|path",
                               "g:not(:hover) .a", ".a\\:b", "@media screen", "@supports (x)"})
    EXPECT_EQ(not_followed(std::string(selector) + "{" +
                           (selector[0] == '@' ? ".a{display:none}" : "display:none") + "}"),
              std::string(selector));
  EXPECT_EQ(not_followed(".a, a+path{display:none}"), "a+path");
  EXPECT_EQ(not_followed("a+path{fill:none} .a{display:none}"), std::nullopt);
  EXPECT_EQ(not_followed(".a:hover, g:focus path{display:none}"), std::nullopt);
  EXPECT_EQ(not_followed("@media screen{a+path{display:none}}"), "@media screen");
}

}  // namespace ribbon::style_sheet_test

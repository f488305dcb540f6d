#include "scene/outside_quotes.h"

#include <gtest/gtest.h>

#include "result/refusal.h"
#include "scene/scene.h"

namespace ribbon::outside_quotes_test {

TEST(OutsideQuotes, strings_and_comments_may_hold_any_letter) {
  for (const char* toml :
       {"", "a = 1", "a = \"\u00fc\" # \u00fc", "a = '\u00fc'", "a = \"\\\"\u00fc\"",
        "a = '\\'  # \u00fc", "a = \"\"\"\n\u00fc \"\u00fc\"\n\"\"\"", "a = '''\n\u00fc\n'''",
        "a = \"\"\"b\"\"\"\" # \"\u00fc\"", "a = '''b'''' # '\u00fc'", "\uFEFFa = 1"})
    EXPECT_FALSE(first_outside_quotes(toml)) << toml;
}

TEST(OutsideQuotes, a_letter_anywhere_else_is_found) {
  EXPECT_EQ(first_outside_quotes("a = \u00fc"), 4U);
  EXPECT_EQ(first_outside_quotes("\u00fc = 1"), 0U);
  EXPECT_EQ(first_outside_quotes("a = \"b\" \u00fc"), 8U);
  EXPECT_EQ(first_outside_quotes("# \u00fc\na = \u00fc"), 9U);
  EXPECT_EQ(first_outside_quotes("a = \"\"\"b\"\"\"\" \u00fc"), 13U);
  EXPECT_EQ(first_outside_quotes("a = \"\"\"b\"\"\"\"\" \u00fc"), 14U);
  EXPECT_EQ(first_outside_quotes("a = \"\"\"b\"\"\"\"\"\" \u00fc\""), std::nullopt)
      << "a string begins there";
  // A string that does not end goes no further than its line.
  EXPECT_EQ(first_outside_quotes("a = \"b\nc = \u00fc"), 11U);
  EXPECT_FALSE(first_outside_quotes("a = \"\u00fc"));
}

TEST(TooDeep, no_scene_has_such_keys) {
  std::string deep = "a";
  for (int i = 0; i < 16; ++i) deep += ". \"a.b\"";
  EXPECT_FALSE(first_too_deep(deep + " = 1"));
  EXPECT_EQ(first_too_deep(deep + ".a = 1"), deep.size());
  EXPECT_EQ(first_too_deep("[" + deep + ".a]"), deep.size() + 1);
  std::string many = "points = [";
  for (int i = 0; i < 100; ++i) many += "[0.1, -.5], # a.b\n";
  EXPECT_FALSE(first_too_deep(many + "]\na.b = 1"));
}

// Deeper than any stack.
TEST(TooDeep, a_scene_is_refused_before_it_is_parsed) {
  std::string deep = "a";
  for (int i = 0; i < 200'000; ++i) deep += ".a";
  EXPECT_THAT(refusal_of(read_scene("knot.toml", "[" + deep + "]\n")),
              StartsWith("knot.toml:1:35: a key goes deeper than there are tables in a scene"));
}

TEST(OutsideQuotes, a_scene_says_where) {
  EXPECT_EQ(
      refusal_of(read_scene("knot.toml", "[ribbon]\nwidth = \u00bd\n")),
      "knot.toml:2:9: a letter that is not plain ASCII stands outside of quotes; put the text "
      "that it belongs to in quotes");
}

}  // namespace ribbon::outside_quotes_test

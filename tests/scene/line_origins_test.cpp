#include "scene/line_origins.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ribbon::line_origins_test {

using testing::ElementsAre;

std::vector<LineOrigin> traced(const std::string& before, const std::string& after) {
  std::vector<LineOrigin> origins = origins_in_file(before);
  trace_setting(3, before, after, origins);
  return origins;
}

TEST(LineOrigins, of_a_text_as_it_is_are_its_lines) {
  EXPECT_THAT(origins_in_file(""), ElementsAre());
  EXPECT_THAT(origins_in_file("a\n\nb"), ElementsAre(1, 2, 3));
  EXPECT_THAT(origins_in_file("a\nb\n"), ElementsAre(1, 2));
}

TEST(LineOrigins, tell_what_a_setting_wrote_wherever_it_stands) {
  EXPECT_THAT(traced("a\nb\n", "x\na\nb\n"), ElementsAre(-3, 1, 2));
  EXPECT_THAT(traced("a\nb\n", "ax\na\nb\n"), ElementsAre(-3, 1, 2)) << "begins as the next";
  EXPECT_THAT(traced("a\nb\n", "a\nx\nb\n"), ElementsAre(1, -3, 2));
  EXPECT_THAT(traced("a\nb\n", "a\nb\n\n[t]\nx\n"), ElementsAre(1, 2, -3, -3, -3));
  EXPECT_THAT(traced("a\nb", "a\nb\n\n[t]\nx\n"), ElementsAre(1, 2, -3, -3, -3));
  EXPECT_THAT(traced("a = 1\nb = 1\nc = 1\n", "a = 1\nb = 2\nc = 1\n"), ElementsAre(1, -3, 3));
  EXPECT_THAT(traced("a\nb = [\n1,\n2]\nc\n", "a\nb = 3\nc\n"), ElementsAre(1, -3, 5));
  EXPECT_THAT(traced("a = 1\n", "a = 1\n"), ElementsAre(1)) << "it says what stands there";
}

}  // namespace ribbon::line_origins_test

#include "commandline/extension.h"

#include <gtest/gtest.h>

namespace ribbon::extension_test {

TEST(Extension, is_the_last_of_the_name_in_lower_case) {
  EXPECT_EQ(lower_case_extension("out.1/Knot.MP4"), ".mp4");
  EXPECT_EQ(lower_case_extension("Knot.{frame}.OBJ"), ".obj");
  EXPECT_EQ(lower_case_extension("knot.\xC3\x84Z"), ".\xC3\x84z");
}

TEST(Extension, is_empty_where_the_name_has_none) {
  EXPECT_EQ(lower_case_extension("out.PNG/knot"), "");
  EXPECT_EQ(lower_case_extension("-"), "");
  EXPECT_EQ(lower_case_extension(".PNG"), "");
}

}  // namespace ribbon::extension_test

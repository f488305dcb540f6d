#include "scene/nearest_word.h"

#include <gtest/gtest.h>

namespace ribbon::nearest_word_test {

TEST(NearestWord, distance_counts_letters_to_change) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("abc", ""), 3);
  EXPECT_EQ(edit_distance("width", "width"), 0);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);  // k-s, e-i, +g
}

TEST(NearestWord, two_swapped_letters_are_one_mistake) {
  EXPECT_EQ(edit_distance("widht", "width"), 1);
  EXPECT_EQ(edit_distance("iwdht", "width"), 2);
}

TEST(NearestWord, case_does_not_matter) {
  EXPECT_EQ(edit_distance("WIDTH", "width"), 0);
}

TEST(NearestWord, the_nearest_word_is_found) {
  EXPECT_EQ(nearest_word("acros", {"along", "across", "mass"}), "across");
  EXPECT_EQ(nearest_word("axes", {"axis_point", "axis"}), "axis");
}

TEST(NearestWord, a_word_of_its_own_has_no_nearest_word) {
  EXPECT_EQ(nearest_word("gravity", {"along", "across", "mass"}), std::nullopt);
  EXPECT_EQ(nearest_word("x", {"yz"}), std::nullopt);
  EXPECT_EQ(nearest_word("width", {}), std::nullopt);
}

}  // namespace ribbon::nearest_word_test

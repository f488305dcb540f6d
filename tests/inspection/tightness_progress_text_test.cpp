#include "inspection/tightness_progress_text.h"

#include <gtest/gtest.h>

namespace ribbon::tightness_progress_text_test {

TEST(ProgressText, is_in_percent) {
  EXPECT_EQ(tightness_progress_text(0.951F), "progress 95.1 %");
  EXPECT_EQ(tightness_progress_text(-0.02F), "progress -2.0 %");
  EXPECT_EQ(tightness_progress_text(9.99F), "progress 999.0 %");
}

TEST(ProgressText, of_hands_that_hardly_pull_has_no_digits) {
  EXPECT_EQ(tightness_progress_text(1.27e9F), "progress over 1000 %");
  EXPECT_EQ(tightness_progress_text(-762149027.84F), "progress below -1000 %");
}

}  // namespace ribbon::tightness_progress_text_test

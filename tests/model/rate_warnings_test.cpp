#include "model/rate_warnings.h"

#include <gtest/gtest.h>

#include "result/refusal.h"

namespace ribbon::rate_warnings_test {

Model at_rate(double frames_per_second) {
  return {.objects = {}, .frames_per_second = frames_per_second};
}

TEST(RateWarnings, rates_that_are_not_whole_drift_in_blender) {
  EXPECT_EQ(whole_rate_warning(at_rate(50), 100), "");
  EXPECT_EQ(whole_rate_warning(at_rate(29.97), 1), "");
  EXPECT_THAT(whole_rate_warning(at_rate(29.97), 2), HasSubstr("29.97 frames a second as 30"));
}

TEST(RateWarnings, times_in_single_precision_are_told_of_where_they_show) {
  for (const double rate : {24.0, 29.97, 50.0}) {
    EXPECT_EQ(rounded_time_warning(at_rate(rate), 10'000), "") << rate;
    EXPECT_THAT(rounded_time_warning(at_rate(rate), 65'536), HasSubstr("% of a frame")) << rate;
  }
}

TEST(RateWarnings, two_become_one_text) {
  EXPECT_EQ(joined_warnings("", ""), "");
  EXPECT_EQ(joined_warnings("a", ""), "a");
  EXPECT_EQ(joined_warnings("", "b"), "b");
  EXPECT_EQ(joined_warnings("a", "b"), "a; b");
}

}  // namespace ribbon::rate_warnings_test

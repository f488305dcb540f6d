#include "simulation/contact/gap_lengths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::gap_lengths_test {

TEST(GapLengths, follow_from_the_edge_while_rounding_is_fine) {
  const GapLengths lengths = gap_lengths(0.01, 1e-9, 0);
  EXPECT_DOUBLE_EQ(lengths.hard_m, 0.0005);
  EXPECT_DOUBLE_EQ(lengths.contact_m, 0.002);
  // By hand: 2 sqrt 3 * 1e-9 is lost.
  EXPECT_NEAR(recorded_gap_m(lengths, 1e-9), 0.0005 - 3.4641e-9, 1e-12);
}

TEST(GapLengths, leave_half_of_the_gap_to_coarse_rounding) {
  const double rounding_m = 1e-4;
  const GapLengths lengths = gap_lengths(0.01, rounding_m, 0);
  EXPECT_NEAR(lengths.hard_m, 4 * std::sqrt(3) * rounding_m, 1e-12);
  EXPECT_NEAR(recorded_gap_m(lengths, rounding_m), lengths.hard_m / 2, 1e-11);
  EXPECT_GE(lengths.contact_m, 2 * lengths.hard_m);
}

TEST(GapLengths, promise_nothing_where_rounding_takes_all) {
  const GapLengths lengths = gap_lengths(0.01, 0.001, 0);
  EXPECT_DOUBLE_EQ(lengths.hard_m, 0.002);
  EXPECT_EQ(recorded_gap_m(lengths, 0.001), 0);
}

TEST(GapLengths, scale_with_everything) {
  const GapLengths one = gap_lengths(0.01, 1e-4, 0);
  const GapLengths thousand = gap_lengths(10, 0.1, 0);
  EXPECT_NEAR(thousand.hard_m, 1000 * one.hard_m, 1e-9);
  EXPECT_NEAR(thousand.contact_m, 1000 * one.contact_m, 1e-9);
}

}  // namespace ribbon::gap_lengths_test

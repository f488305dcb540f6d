#include "simulation/contact/contact_lengths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon::contact_lengths_test {

TEST(ContactLengths, follow_from_the_edge_while_rounding_is_fine) {
  const ContactLengths lengths = contact_lengths(0.01, 1e-9, 0);
  EXPECT_DOUBLE_EQ(lengths.min_separation_m, 0.0005);
  EXPECT_DOUBLE_EQ(lengths.activation_m, 0.002);
  // By hand: 2 sqrt 3 * 1e-9 is lost.
  EXPECT_NEAR(recorded_gap_m(lengths), 0.0005 - 3.4641e-9, 1e-12);
}

TEST(ContactLengths, leave_half_of_the_gap_to_coarse_rounding) {
  const double rounding_m = 1e-4;
  const ContactLengths lengths = contact_lengths(0.01, rounding_m, 0);
  EXPECT_NEAR(lengths.min_separation_m, 4 * std::sqrt(3) * rounding_m, 1e-12);
  EXPECT_NEAR(recorded_gap_m(lengths), lengths.min_separation_m / 2, 1e-11);
  EXPECT_GE(lengths.activation_m, 2 * lengths.min_separation_m);
}

TEST(ContactLengths, promise_nothing_where_rounding_takes_all) {
  const ContactLengths lengths = contact_lengths(0.01, 0.001, 0);
  EXPECT_DOUBLE_EQ(lengths.min_separation_m, 0.002);
  EXPECT_EQ(recorded_gap_m(lengths), 0);
}

TEST(ContactLengths, scale_with_everything) {
  const ContactLengths one = contact_lengths(0.01, 1e-4, 0);
  const ContactLengths thousand = contact_lengths(10, 0.1, 0);
  EXPECT_NEAR(thousand.min_separation_m, 1000 * one.min_separation_m, 1e-9);
  EXPECT_NEAR(thousand.activation_m, 1000 * one.activation_m, 1e-9);
}

}  // namespace ribbon::contact_lengths_test

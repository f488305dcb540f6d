#include "knot/type/laurent_polynomial.h"

#include <gtest/gtest.h>

#include <limits>

namespace ribbon::laurent_polynomial_test {

const LaurentPolynomial right_trefoil{1, {1, 0, 1, -1}};

TEST(LaurentPolynomial, reads_as_one_writes_it) {
  EXPECT_EQ(right_trefoil.text(), "t + t^3 - t^4");
  EXPECT_EQ((LaurentPolynomial{-2, {-3, 0, 2}}).text(), "-3 t^-2 + 2");
  EXPECT_EQ(LaurentPolynomial{}.text(), "0");
}

TEST(LaurentPolynomial, the_mirror_turns_powers_round) {
  EXPECT_EQ(right_trefoil.mirrored(), (LaurentPolynomial{-4, {-1, 1, 0, 1}}));
  EXPECT_EQ(right_trefoil.mirrored().mirrored(), right_trefoil);
}

TEST(LaurentPolynomial, adds_and_drops_what_vanishes) {
  EXPECT_EQ(sum({0, {1, 2}}, {1, {-2, 0, 5}}), (LaurentPolynomial{0, {1, 0, 0, 5}}));
  EXPECT_EQ(sum({0, {1, 2}}, {0, {-1, 3}}), (LaurentPolynomial{1, {5}}));
  EXPECT_EQ(sum({3, {4}}, {3, {-4}}), LaurentPolynomial{});
}

TEST(LaurentPolynomial, multiplies) {
  // (t^-1 + 1)(t - 1) = 1 - t^-1 + t - 1
  EXPECT_EQ(product({-1, {1, 1}}, {0, {-1, 1}}), (LaurentPolynomial{-1, {-1, 0, 1}}));
  EXPECT_EQ(product(right_trefoil, {}), LaurentPolynomial{});
}

TEST(LaurentPolynomial, too_large_coefficients_are_refused) {
  const auto huge = LaurentPolynomial::monomial(std::numeric_limits<std::int64_t>::max(), 0);
  EXPECT_FALSE(sum(huge, LaurentPolynomial::monomial(1, 0)));
  EXPECT_FALSE(product(huge, LaurentPolynomial::monomial(2, 0)));
  EXPECT_TRUE(sum(huge, LaurentPolynomial::monomial(1, 1)));
}

}  // namespace ribbon::laurent_polynomial_test

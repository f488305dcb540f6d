#include "knot/type/jones_polynomial.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "knot/knotted_curves.h"
#include "knot/type/knot_names.h"
#include "knot/type/regina_oracle.h"

namespace ribbon::jones_polynomial_test {

LaurentPolynomial jones_of(const std::vector<int>& braid) {
  return jones_polynomial(braid_knot(braid)).value();
}

TEST(JonesPolynomial, is_that_of_the_literature) {
  EXPECT_EQ(jones_polynomial({}).value().text(), "1");
  EXPECT_EQ(jones_of({1}).text(), "1");
  EXPECT_EQ(jones_of({1, 1, 1}).text(), "t + t^3 - t^4");
  EXPECT_EQ(jones_of({-1, -1, -1}).text(), "-t^-4 + t^-3 + t^-1");
  EXPECT_EQ(jones_of({1, -2, 1, -2}).text(), "t^-2 - t^-1 + 1 - t + t^2");
}

TEST(JonesPolynomial, of_one_knot_after_the_other_is_the_product) {
  const LaurentPolynomial right = jones_of({1, 1, 1});
  EXPECT_EQ(jones_of({1, 1, 1, 2, 2, 2}), product(right, right));
  EXPECT_EQ(jones_of({1, 1, 1, -2, -2, -2}), product(right, right.mirrored()));
}

bool closes_to_one_strand(const std::vector<int>& letters, int strands) {
  int length = 0;
  int strand = 0;
  do {
    for (const int letter : letters) {
      const int left = std::abs(letter) - 1;
      if (strand == left || strand == left + 1) strand = 2 * left + 1 - strand;
    }
    ++length;
  } while (strand != 0);
  return length == strands;
}

std::vector<int> random_knot_braid(int strands, int letters, std::mt19937& random) {
  std::uniform_int_distribution<int> generator(1, strands - 1);
  std::vector<int> result(static_cast<std::size_t>(letters));
  do {
    for (int& letter : result) letter = generator(random) * (random() % 2 == 0 ? 1 : -1);
  } while (!closes_to_one_strand(result, strands));
  return result;
}

TEST(JonesPolynomial, agrees_with_regina_on_random_braids) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const int strands = 2 + round % 4;
    const int letters = strands + 2 * (round % 9) + 1;
    const KnotDiagram knot =
        braid_knot(random_knot_braid(strands, letters + (letters + strands + 1) % 2, random));
    const auto ours = jones_polynomial(knot).value();
    EXPECT_EQ(ours, regina_jones(knot)) << "round " << round;
  }
}

TEST(JonesPolynomial, of_forty_crossings_agrees_with_regina) {
  std::mt19937 random(2);
  for (int round = 0; round < 5; ++round) {
    const KnotDiagram knot = braid_knot(random_knot_braid(5, 40, random));
    EXPECT_EQ(jones_polynomial(knot), regina_jones(knot));
  }
}

TEST(JonesPolynomial, is_refused_when_the_knot_is_too_tangled) {
  // The torus knot of 19 strands: every line through the diagram cuts at least 18.
  std::vector<int> letters;
  for (int turn = 0; turn < 20; ++turn)
    for (int letter = 1; letter < 19; ++letter) letters.push_back(letter);
  EXPECT_FALSE(jones_polynomial(braid_knot(letters)));
}

// A random walk from left to right, of which Regina sees the diagram as it is and we a simplified
// one.
TEST(JonesPolynomial, of_a_simplified_random_walk_agrees_with_regina_on_the_walk_itself) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int knotted = 0;
  for (int round = 0; round < 60; ++round) {
    const Curve walk = sampled(14 + round % 8, [&](double) {
      return Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
    });
    const LongCurve curve = long_curve(walk, {-1, 0.1, 0.2}, {1, 0.2, 0.1});
    const auto whole = diagram(curve, ProjectivePoint::direction({0.1, 0.2, 1}));
    const auto simple = simple_diagram(simplified(curve));
    ASSERT_TRUE(whole && simple);
    const auto ours = jones_polynomial(*simple).value();
    EXPECT_EQ(ours, regina_jones(*whole)) << "round " << round;
    knotted += knot_name(ours) == "unknot" ? 0 : 1;
  }
  EXPECT_GE(knotted, 10);
}

}  // namespace ribbon::jones_polynomial_test

#include "knot/type/knot_names.h"

#include <gtest/gtest.h>

#include "knot/knotted_curves.h"
#include "knot/type/jones_polynomial.h"
#include "knot/type/regina_oracle.h"

namespace ribbon::knot_names_test {

std::string name_of(const LongCurve& curve) {
  const auto seen = simple_diagram(simplified(curve));
  const auto jones = seen ? jones_polynomial(*seen) : std::nullopt;
  return jones ? knot_name(*jones).value_or("no name") : "no polynomial";
}

std::string name_along_x(const Curve& curve) {
  return name_of(long_curve(curve, {-1, 0, 0.01}, {1, 0, 0}));
}

TEST(KnotNames, curves_from_formulas_are_recognised) {
  EXPECT_EQ(name_of(long_curve(torus_knot(2, 1, 200))), "unknot");
  EXPECT_EQ(name_of(long_curve(torus_knot(2, 3, 200))), "trefoil, right-handed (3 crossings)");
  EXPECT_EQ(name_of(long_curve(torus_knot(2, -3, 200))), "trefoil, left-handed (3 crossings)");
  EXPECT_EQ(name_of(long_curve(torus_knot(2, 5, 200))),
            "cinquefoil knot 5_1, right-handed (5 crossings)");
  EXPECT_EQ(name_of(long_curve(torus_knot(3, -4, 300))),
            "torus knot 8_19, left-handed (8 crossings)");
  EXPECT_EQ(name_of(long_curve(figure_eight_knot(300))), "figure-eight knot (4 crossings)");
  EXPECT_EQ(name_along_x(overhand_knot(200)), "trefoil, right-handed (3 crossings)");
  EXPECT_EQ(name_along_x(overhand_knot(200, 6, -1)), "trefoil, left-handed (3 crossings)");
}

TEST(KnotNames, granny_and_reef_knot_differ) {
  const Curve right = overhand_knot(100);
  const Curve left = overhand_knot(100, 6, -1);
  EXPECT_EQ(name_along_x(joined(right, right)), "granny knot, right-handed (6 crossings)");
  EXPECT_EQ(name_along_x(joined(left, left)), "granny knot, left-handed (6 crossings)");
  EXPECT_EQ(name_along_x(joined(right, left)), "reef knot (6 crossings)");
}

TEST(KnotNames, stay_whichever_way_the_curve_is_turned_and_divided) {
  std::mt19937 random(4);
  std::normal_distribution<double> jitter(0, 1e-3);
  for (int round = 0; round < 40; ++round) {
    const Curve knot =
        round % 2 == 0 ? torus_knot(2, -5, 60 + 7 * round) : figure_eight_knot(80 + 7 * round);
    Curve turned = random_rotation(random) * knot;
    for (double& coordinate : turned.reshaped()) coordinate += jitter(random);
    EXPECT_EQ(name_of(long_curve(turned)), round % 2 == 0
                                               ? "cinquefoil knot 5_1, left-handed (5 crossings)"
                                               : "figure-eight knot (4 crossings)");
  }
}

struct TabulatedKnot {
  std::string name;
  std::vector<int> dowker_thistlethwaite;  // from Rolfsen's table of knots
};

TEST(KnotNames, are_those_of_the_knot_table) {
  const std::vector<TabulatedKnot> table{{"trefoil", {4, 6, 2}},
                                         {"figure-eight knot", {4, 6, 8, 2}},
                                         {"cinquefoil knot 5_1", {6, 8, 10, 2, 4}},
                                         {"three-twist knot 5_2", {4, 8, 10, 2, 6}},
                                         {"stevedore knot 6_1", {4, 8, 12, 10, 2, 6}},
                                         {"knot 6_2", {4, 8, 10, 12, 2, 6}},
                                         {"knot 6_3", {4, 8, 10, 2, 12, 6}},
                                         {"septafoil knot 7_1", {8, 10, 12, 14, 2, 4, 6}},
                                         {"knot 7_2", {4, 10, 14, 12, 2, 8, 6}},
                                         {"knot 7_3", {6, 10, 12, 14, 2, 4, 8}},
                                         {"knot 7_4", {6, 10, 12, 14, 4, 2, 8}},
                                         {"knot 7_5", {4, 10, 12, 14, 2, 8, 6}},
                                         {"knot 7_6", {4, 8, 12, 2, 14, 6, 10}},
                                         {"knot 7_7", {4, 8, 10, 12, 2, 14, 6}},
                                         {"carrick mat 8_18", {6, 8, 10, 12, 14, 16, 2, 4}},
                                         {"torus knot 8_19", {4, 8, -12, 2, -14, -16, -6, -10}}};
  for (const auto& [name, code] : table) {
    const LaurentPolynomial jones = regina_jones_of_code(code);
    const std::string crossings = " (" + std::to_string(code.size()) + " crossings)";
    const std::string right = std::string(name).append(", right-handed").append(crossings);
    const std::string left = std::string(name).append(", left-handed").append(crossings);
    const auto named = knot_name(jones);
    ASSERT_TRUE(named) << name;
    if (jones == jones.mirrored()) {
      EXPECT_EQ(*named, std::string(name).append(crossings));
    } else {
      EXPECT_TRUE(*named == right || *named == left) << *named;
      EXPECT_EQ(knot_name(jones.mirrored()), *named == right ? left : right);
    }
  }
}

TEST(KnotNames, a_braid_is_named_right_handed_where_its_least_diagram_is) {
  // These braids are least diagrams.
  EXPECT_EQ(knot_name(jones_polynomial(braid_knot({1, 1, 1, 1, 1, 1, 1})).value()),
            "septafoil knot 7_1, right-handed (7 crossings)");
  EXPECT_EQ(knot_name(jones_polynomial(braid_knot({1, 1, 1, -2, 1, -2})).value()),
            "knot 6_2, right-handed (6 crossings)");
  EXPECT_EQ(knot_name(jones_polynomial(braid_knot({-1, -1, -1, 2, -1, 2})).value()),
            "knot 6_2, left-handed (6 crossings)");
}

TEST(KnotNames, an_unusual_knot_has_none) {
  EXPECT_FALSE(knot_name(jones_polynomial(braid_knot({1, 1, 1, 1, 1, 1, 1, 1, 1})).value()));
}

}  // namespace ribbon::knot_names_test

#include "knot/type/tied_forms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

#include "knot/type/jones_polynomial.h"

namespace ribbon::tied_forms_test {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

// Of a Gauss code as gauss_code() writes it.
KnotDiagram drawing(const std::string& code) {
  KnotDiagram diagram;
  std::istringstream words(code);
  for (std::string word; words >> word;) {
    const int crossing = std::stoi(word.substr(1)) - 1;
    diagram.passes.push_back({crossing, word[0] == 'O'});
    diagram.signs.resize(std::max(diagram.signs.size(), static_cast<std::size_t>(crossing) + 1));
    diagram.signs[static_cast<std::size_t>(crossing)] = word.back() == '+' ? 1 : -1;
  }
  return diagram;
}

// The alternating sum of the coefficients: the value at t = -1.
std::int64_t determinant(const KnotDiagram& diagram) {
  const LaurentPolynomial jones = jones_polynomial(reduced(diagram)).value();
  std::int64_t value = 0;
  for (std::size_t k = 0; k < jones.coefficients.size(); ++k)
    value += (k % 2 == 0 ? 1 : -1) * jones.coefficients[k];
  return std::abs(value);
}

const std::string bow =
    "O1- O2+ U3+ U4- O5- O6+ O7- O8+ U9+ U10- O11- O12+ O13- U14- O15- U13- O14- U15- U8+ U5- O4- "
    "O9+ U12+ U1- U2+ U11- O10- O3+ U6+ U7-";
const std::string four_in_hand = "U1- O2- U3- O4- U5- O3- U2- U6+ O7+ O1- U4- O5- O6+ U7+";
const std::string windsor =
    "U1+ O2- O3- O4+ O5+ U6- O7- O1+ U8+ U5+ O9+ U10+ U2- O11- U4+ U12- O13- U3- U11- O8+ O6- U9+ "
    "O12- U13- O10+ U7-";
const std::string reef = "O1- U2- O3- O4+ U5+ O6+ U4+ O5+ U6+ U1- O2- U3-";
const std::string granny = "O1- U2- O3- U4- O5- U6- O4- U5- O6- U1- O2- U3-";

TEST(TiedForms, gauss_code_is_written_as_it_is_read) {
  EXPECT_EQ(gauss_code(drawing(bow)), bow);
  EXPECT_EQ(gauss_code({}), "");
}

TEST(TiedForms, knots_of_the_gallery_can_be_drawn_and_close_to_the_types_in_books) {
  const std::map<std::string, std::int64_t> determinants = {
      {"O1- U2- O3- U1- O2- U3-", 3},
      {"O1+ U2+ O3- U4- O2+ U1+ O4- U3-", 5},
      {"O1- U2- O3- U4- O5- U1- O2- U3- O4- U5-", 5},
      {"O1+ U2+ O3+ U4+ O5- U6- O4+ U3+ O2+ U1+ O6- U5-", 9},
      {granny, 9},
      {reef, 9},
      {bow, 3},
      {four_in_hand, 3},
      {windsor, 3}};
  for (const auto& [code, expected] : determinants) {
    EXPECT_TRUE(is_planar(drawing(code))) << code;
    EXPECT_EQ(determinant(drawing(code)), expected) << code;
  }
}

TEST(TiedForms, a_closed_type_has_a_general_name_a_hand_and_other_names) {
  EXPECT_THAT(knot_names(drawing("O1- U2- O3- U1- O2- U3-")),
              ElementsAre("trefoil, left-handed", "trefoil", "overhand knot"));
  EXPECT_THAT(knot_names(drawing(reef)), ElementsAre("reef knot", "square knot"));
  EXPECT_THAT(knot_names(drawing(granny)), ElementsAre("granny knot, left-handed", "granny knot"));
}

TEST(TiedForms, slipped_knots_have_their_own_name_and_that_of_the_trefoil) {
  EXPECT_THAT(knot_names(drawing(bow)), Contains("bow"));
  EXPECT_THAT(knot_names(drawing(four_in_hand)), Contains("four-in-hand"));
  EXPECT_THAT(knot_names(drawing(windsor)), Contains("Windsor knot"));
  for (const std::string& code : {bow, four_in_hand, windsor})
    EXPECT_THAT(knot_names(drawing(code)), Contains("trefoil"));
}

TEST(TiedForms, a_bow_is_one_walked_backwards_seen_from_behind_and_mirrored) {
  KnotDiagram other = drawing(bow);
  std::reverse(other.passes.begin(), other.passes.end());
  EXPECT_THAT(knot_names(other), Contains("bow"));
  for (KnotDiagram::Pass& pass : other.passes) pass.over = !pass.over;
  EXPECT_THAT(knot_names(other), Contains("bow"));
  for (int& sign : other.signs) sign = -sign;
  EXPECT_THAT(knot_names(other), Contains("bow"));
  EXPECT_THAT(knot_names(other), Contains("trefoil"));
}

TEST(TiedForms, a_bow_with_one_crossing_changed_is_none) {
  KnotDiagram other = drawing(bow);
  for (KnotDiagram::Pass& pass : other.passes) pass.over = pass.over != (pass.crossing == 4);
  other.signs[4] = -other.signs[4];
  EXPECT_THAT(knot_names(other), Not(Contains("bow")));
}

TEST(TiedForms, a_drawing_with_an_end_inside_a_loop_has_no_type) {
  // The drawing of crossings_test.cpp whose first end is shut in.
  const KnotDiagram shut_in = drawing("O1+ O2+ U1+ U2+");
  EXPECT_FALSE(is_planar(shut_in));
  EXPECT_THAT(knot_names(shut_in), IsEmpty());
  EXPECT_TRUE(is_planar(drawing("O1+ U1+")));
  EXPECT_TRUE(is_planar({}));
}

TEST(TiedForms, every_name_that_a_drawing_can_have_is_known) {
  for (const std::string& code : {bow, four_in_hand, windsor, reef, granny})
    for (const std::string& name : knot_names(drawing(code)))
      EXPECT_THAT(known_knot_names(), Contains(name));
}

}  // namespace ribbon::tied_forms_test

#include "converter/export/usd_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace ribbon::usd_text_test {

TEST(UsdText, an_identifier_has_letters_digits_and_underscores_only) {
  EXPECT_EQ(usd_identifier("knot_16"), "knot_16");
  EXPECT_EQ(usd_identifier("half-knot 16x400"), "half_knot_16x400");
  EXPECT_EQ(usd_identifier("2nd knot"), "_2nd_knot");
  EXPECT_EQ(usd_identifier("Knöten"), "Kn_ten");
  EXPECT_EQ(usd_identifier("/a\"b\\"), "_a_b_");
  EXPECT_EQ(usd_identifier(""), "_");
}

TEST(UsdText, quotation_marks_and_backslashes_are_escaped) {
  EXPECT_EQ(usd_string(R"(a "knot" \o/ ö)"), R"("a \"knot\" \\o/ ö")");
}

TEST(UsdText, arrays_are_in_brackets) {
  EXPECT_EQ(usd_array(Eigen::Vector3i(1, -2, 3)), "[1, -2, 3]");
  EXPECT_EQ(usd_array(Eigen::VectorXi()), "[]");
  Eigen::Matrix<float, 2, 3> columns;
  columns << 0.1F, 2, -1e-7F, 3, 0, 1e20F;
  EXPECT_EQ(usd_array_of_tuples(columns), "[(0.1, 3), (2, 0), (-1e-07, 1e+20)]");
  EXPECT_EQ(usd_array_of_tuples(Eigen::Matrix3Xf(3, 0)), "[]");
}

TEST(UsdText, the_longest_numbers_have_room) {
  const Eigen::Matrix3Xf longest =
      Eigen::Matrix3Xf::Constant(3, 3000, -std::numeric_limits<float>::min());
  const std::string text = usd_array_of_tuples(longest);
  const std::string tuple = "(-1.1754944e-38, -1.1754944e-38, -1.1754944e-38)";
  EXPECT_EQ(text.size(), 3000 * (tuple.size() + 2));
  EXPECT_EQ(text.substr(text.size() - 1 - tuple.size()), tuple + "]");
}

TEST(UsdText, addresses_of_files_may_hold_an_at_sign) {
  EXPECT_EQ(usd_asset("first knot.png"), "@./first knot.png@");
  EXPECT_EQ(usd_asset("kn@t.png"), "@@@./kn@t.png@@@");
  EXPECT_EQ(usd_asset("kn@@@@t.png"), "@@@./kn\\@@@@t.png@@@");
}

}  // namespace ribbon::usd_text_test

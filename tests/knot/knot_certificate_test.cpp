#include "knot/knot_certificate.h"

#include <gtest/gtest.h>

namespace ribbon::knot_certificate_test {

KnotCertificate trefoil() {
  KnotCertificate result;
  result.jones = LaurentPolynomial{1, {1, 0, 1, -1}};
  result.turns_round_object = 1;
  result.selvage_linking = 2;
  return result;
}

TEST(KnotCertificate, reads_as_a_sentence) {
  EXPECT_EQ(
      trefoil().text(),
      "trefoil, right-handed (3 crossings); 1 turn round the object; selvages linked 2 times");
}

TEST(KnotCertificate, without_an_axis_names_no_turns) {
  KnotCertificate certificate = trefoil();
  certificate.turns_round_object.reset();
  certificate.selvage_linking = -1;
  EXPECT_EQ(certificate.text(), "trefoil, right-handed (3 crossings); selvages linked -1 time");
}

TEST(KnotCertificate, an_unusual_knot_shows_its_polynomial) {
  KnotCertificate certificate;
  certificate.jones = LaurentPolynomial{4, {1, 0, 1, -1, 1, -1, 1, -1, 1, -1}};
  EXPECT_EQ(certificate.text(),
            "knot with Jones polynomial t^4 + t^6 - t^7 + t^8 - t^9 + t^10 - t^11 + t^12 - t^13");
}

TEST(KnotCertificate, what_is_not_known_is_said) {
  KnotCertificate certificate;
  EXPECT_EQ(certificate.text(), "knot too tangled to be known");
  certificate.last_end_buried = true;
  EXPECT_EQ(certificate.text(), "last end buried, knot unknown");
  certificate.first_end_buried = true;
  EXPECT_EQ(certificate.text(), "first end buried, knot unknown");
  certificate.broken_positions = true;
  EXPECT_EQ(certificate.text(), "broken positions");
}

TEST(KnotCertificate, differs_by_each_of_its_parts) {
  const auto changed = [](auto change) {
    KnotCertificate certificate = trefoil();
    change(certificate);
    return certificate != trefoil();
  };
  EXPECT_FALSE(changed([](KnotCertificate&) {}));
  EXPECT_TRUE(changed([](KnotCertificate& c) { c.jones = c.jones->mirrored(); }));
  EXPECT_TRUE(changed([](KnotCertificate& c) { c.selvage_linking = 4; }));
  EXPECT_TRUE(changed([](KnotCertificate& c) { c.turns_round_object = 0; }));
  EXPECT_TRUE(changed([](KnotCertificate& c) { c.object_met = true; }));
  EXPECT_TRUE(changed([](KnotCertificate& c) { c.first_end_buried = true; }));
}

}  // namespace ribbon::knot_certificate_test

#include "simulation/fastening/yielding.h"

#include <gtest/gtest.h>

#include "simulation/published/planted_penetrations.h"

namespace ribbon::yielding_test {

constexpr RestSize size{{101, 2}, 100, 1};

double fraction_at(double stretch) {
  Yielding yielding(size, 0.05);
  Eigen::Matrix3Xd stretched = flat_ribbon(size.grid);
  stretched.row(0) *= 1 + stretch;
  return yielding.force_fraction(stretched);
}

TEST(Yielding, leaves_the_force_of_a_slightly_stretched_ribbon_alone) {
  for (const double stretch : {-0.1, 0.0, 0.024}) EXPECT_EQ(fraction_at(stretch), 1) << stretch;
}

TEST(Yielding, gives_way_in_proportion_to_the_stretch) {
  EXPECT_NEAR(fraction_at(0.0375), 0.75, 1e-12);
  EXPECT_NEAR(fraction_at(0.05), 0.5, 1e-12);
  EXPECT_NEAR(fraction_at(0.0625), 0.25, 1e-12);
}

TEST(Yielding, gives_way_altogether_at_one_and_a_half_of_its_strain) {
  for (const double stretch : {0.0751, 3.0}) EXPECT_EQ(fraction_at(stretch), 0) << stretch;
}

TEST(Yielding, of_a_ribbon_with_a_profile_goes_by_its_own_rest_lengths) {
  RestSize tapered = size;
  for (int row = 0; row < size.grid.along; ++row) tapered.row_widths_m.push_back(1 + 0.8 * row);
  const auto fraction_at = [&](double stretch) {
    Eigen::Matrix3Xd stretched(3, size.grid.particle_count());
    for (int p = 0; p < size.grid.particle_count(); ++p)
      stretched.col(p) << (1 + stretch) * tapered.place_m(p), 0;
    return Yielding(tapered, 0.05).force_fraction(stretched);
  };
  EXPECT_EQ(fraction_at(0.024), 1);
  EXPECT_NEAR(fraction_at(0.05), 0.5, 1e-9);
}

TEST(Yielding, does_not_mind_one_row_in_a_hundred) {
  // By hand: edges lead from 100 rows, so those of one may be stretched.
  Yielding yielding(size, 0.05);
  Eigen::Matrix3Xd two_stretched = flat_ribbon(size.grid);
  two_stretched.row(0).tail(2).array() += 0.5;
  EXPECT_EQ(yielding.force_fraction(two_stretched), 1);
  two_stretched(0, 0) -= 0.5;
  EXPECT_EQ(yielding.force_fraction(two_stretched), 0);
}

// Bent in its plane, a ribbon is stretched along one selvage and shrunk along the other.
TEST(Yielding, does_not_mind_what_is_bent_to_the_side) {
  Yielding yielding(size, 0.05);
  Eigen::Matrix3Xd bent = flat_ribbon(size.grid);
  for (int p = 0; p < size.grid.particle_count(); ++p)
    bent(0, p) *= size.grid.column(p) == 0 ? 1.2 : 0.8;
  EXPECT_EQ(yielding.force_fraction(bent), 1);
}

}  // namespace ribbon::yielding_test

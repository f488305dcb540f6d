#include "simulation/truncation/strain_constraints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ribbon::strain_constraints_test {

using Eigen::Matrix3Xd;

// Of a ribbon at rest.
bool tighten(const StrainConstraints& constraints, SweepActivity& activity, Matrix3Xd& positions) {
  Cloth cloth{positions, Matrix3Xd::Zero(3, positions.cols()), 1};
  const bool any = constraints.tighten(activity, cloth);
  positions = cloth.positions;
  return any;
}

TEST(StrainConstraints, brings_a_long_edge_back_about_its_middle) {
  const StrainConstraints constraints({2, 1}, {{{1, 0, 1}, 0.1}});
  SweepActivity activity = constraints.activity();
  Matrix3Xd x(3, 2);
  x << 0, 0, 0, 2, 0, 0;
  EXPECT_DOUBLE_EQ(constraints.excess(x).beyond_aimed, 1 - 0.1);
  EXPECT_TRUE(tighten(constraints, activity, x));
  // By hand: one and a half of the excess would be more than there is to its rest length.
  EXPECT_NEAR(x(1, 0), 0.5, 1e-15);
  EXPECT_NEAR(x(1, 1), 1.5, 1e-15);
  // Of an excess of 0.1 m, 0.15 m are taken back.
  x << 0, 0, 0, 1.2, 0, 0;
  EXPECT_TRUE(tighten(constraints, activity, x));
  EXPECT_NEAR(x(1, 1) - x(1, 0), 1.05, 1e-15);
}

TEST(StrainConstraints, brings_a_short_edge_back) {
  const StrainConstraints constraints({2, 1}, {{{1, 0, 1}, 0.1}});
  SweepActivity activity = constraints.activity();
  Matrix3Xd x(3, 2);
  x << 0, 0.5, 0, 0, 0, 0;
  EXPECT_TRUE(tighten(constraints, activity, x));
  EXPECT_NEAR(x(0, 1) - x(0, 0), 1, 1e-15);
}

TEST(StrainConstraints, leaves_alone_what_is_within_it) {
  const StrainConstraints constraints({3, 1}, {{{1, 0, 1}, 0.1}});
  SweepActivity activity = constraints.activity();
  Matrix3Xd x(3, 3);
  x << 0, 1.09, 2, 0, 0, 0, 0, 0, 0;
  const Matrix3Xd before = x;
  EXPECT_FALSE(tighten(constraints, activity, x));
  EXPECT_EQ(x, before);
}

// By hand: the pair parts at 3 m/s along, keeps what it has across, and shares its momentum of 1.
TEST(StrainConstraints, take_the_speed_that_worsens_and_no_other) {
  const StrainConstraints constraints({2, 1}, {{{1, 0, 1}, 0.1, 0.1}});
  Cloth cloth{Matrix3Xd::Zero(3, 2), Matrix3Xd::Zero(3, 2), 1};
  cloth.positions(0, 1) = 1.5;
  cloth.velocities << -1, 2, 5, 7, 0, 0;
  SweepActivity activity = constraints.activity();
  constraints.tighten(activity, cloth);
  EXPECT_TRUE(cloth.velocities.isApprox((Matrix3Xd(3, 2) << 0.5, 0.5, 5, 7, 0, 0).finished()));
  cloth.positions(0, 1) = cloth.positions(0, 0) + 1.5;
  cloth.velocities << 1, -2, 5, 7, 0, 0;
  const Matrix3Xd closing = cloth.velocities;
  constraints.tighten(activity, cloth);
  EXPECT_EQ(cloth.velocities, closing);
}

TEST(StrainConstraints, hold_up_to_what_a_step_may_leave) {
  const StrainConstraints constraints({2, 1}, {{{1, 0, 1}, 0.05, 0.09}});
  const auto hold = [&](double length_m) {
    return constraints.excess((Matrix3Xd(3, 2) << 0, length_m, 0, 0, 0, 0).finished()).is_bearable;
  };
  for (const double length_m : {0.911, 1.0, 1.089}) EXPECT_TRUE(hold(length_m)) << length_m;
  for (const double length_m : {0.909, 1.091}) EXPECT_FALSE(hold(length_m)) << length_m;
}

TEST(StrainConstraints, repeated_sweeps_share_one_long_edge_among_its_neighbours) {
  const StrainConstraints constraints({10, 1}, {{{1, 0, 1}, 0.1}});
  SweepActivity activity = constraints.activity();
  Matrix3Xd x = Matrix3Xd::Zero(3, 10);
  for (int i = 0; i < 10; ++i) x(0, i) = i < 5 ? i : i + 0.6;
  int sweeps = 0;
  while (tighten(constraints, activity, x) && ++sweeps < 200) continue;
  EXPECT_LT(sweeps, 200);
  EXPECT_LT(constraints.excess(x).beyond_aimed, 0.003);
}

// By hand: edges along are 0.1 beyond the 0.2 aimed at, those across 0.15 beyond their own
// 0.05; one and a half of that is taken back, but not beyond the rest length.
TEST(StrainConstraints, brings_each_kind_of_edge_to_what_is_aimed_at_for_it) {
  const StrainConstraints constraints({2, 2}, {{{1, 0, 1}, 0.2}, {{0, 1, 1}, 0.05}});
  SweepActivity activity = constraints.activity();
  Matrix3Xd x(3, 4);
  x << 0, 1.2, 0, 1.2, 0, 0, 1.3, 1.3, 0, 0, 0, 0;
  EXPECT_NEAR(constraints.excess(x).beyond_aimed, 0.15, 1e-12);
  while (tighten(constraints, activity, x)) continue;
  EXPECT_NEAR(x(1, 2) - x(1, 0), 1.15, 0.003);
  EXPECT_NEAR(x(0, 3) - x(0, 2), 1, 0.003);
}

// By hand: all diagonals of unit quads are sqrt 2 long; then an end is moved until its own is 2
// sqrt 2.
TEST(StrainConstraints, finds_diagonals_of_both_directions_and_none_over_the_selvage) {
  const RibbonGrid grid{2, 4};
  Matrix3Xd x(3, 8);
  x << 0, 1, 2, 3, 0, 1, 2, 3, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0;
  for (const int columns : {1, -1}) {
    const StrainConstraints constraints(grid, {{{1, columns, std::sqrt(2.0)}, 0.1}});
    EXPECT_NEAR(constraints.excess(x).beyond_aimed, -0.1, 1e-12);
    Matrix3Xd stretched = x;
    stretched(1, columns == 1 ? 7 : 4) = std::sqrt(7.0);
    EXPECT_NEAR(constraints.excess(stretched).beyond_aimed, 1 - 0.1, 1e-12);
  }
}

// What rests may be passed over because it would stay as it is.
TEST(StrainConstraints, sweeps_to_the_same_bits_whether_it_looks_at_resting_rows_or_not) {
  const RibbonGrid grid{60, 5};
  const StrainConstraints constraints(
      grid, {{{1, 0, 1}, 0.1}, {{0, 1, 1}, 0.1}, {{1, 1, std::sqrt(2.0)}, 0.1}});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> kick(-0.4, 0.4);
  Matrix3Xd x(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    x.col(p) << grid.row(p), grid.column(p), 0;
    if (grid.row(p) % 20 < 4) x(0, p) += kick(random);
  }
  Matrix3Xd all = x;
  SweepActivity activity = constraints.activity();
  int resting = 0;
  for (int sweep = 0; sweep < 15; ++sweep) {
    SweepActivity none = constraints.activity();
    const bool any = tighten(constraints, none, all);
    ASSERT_EQ(tighten(constraints, activity, x), any);
    ASSERT_EQ(x, all) << sweep;
    if (sweep < 3) continue;
    for (int row = 0; row < grid.along; ++row) resting += activity.is_resting(row) ? 1 : 0;
  }
  EXPECT_GT(resting, 100);
}

TEST(StrainConstraints, aims_at_what_the_scene_says_where_rounding_leaves_room) {
  EXPECT_EQ(aimed_strain(0.08, 1, 0), 0.08);
  EXPECT_EQ(aimed_strain(0.05, 1, 0.01), 0.05);
}

// By hand: rounding by 0.01 m moves the ends of an edge of 1 m by up to 2 sqrt 3 0.01 m, 3.46 %.
TEST(StrainConstraints, aims_lower_by_what_rounding_may_take_from_an_edge) {
  EXPECT_NEAR(aimed_strain(0.08, 1, 0.01), 0.099 - 0.034641 - 0.008, 1e-6);
  EXPECT_NEAR(aimed_strain(0.08, 2, 0.01), 0.099 - 0.017321 - 0.008, 1e-6);
}

TEST(StrainConstraints, aims_at_two_percent_where_rounding_leaves_no_room) {
  EXPECT_EQ(aimed_strain(0.08, 1, 0.03), 0.02);
}

TEST(StrainConstraints, an_edge_without_length_has_no_direction_and_stays) {
  const StrainConstraints constraints({2, 1}, {{{1, 0, 1}, 0.1}});
  SweepActivity activity = constraints.activity();
  Matrix3Xd x = Matrix3Xd::Zero(3, 2);
  EXPECT_FALSE(tighten(constraints, activity, x));
  EXPECT_TRUE(x.allFinite());
}

}  // namespace ribbon::strain_constraints_test

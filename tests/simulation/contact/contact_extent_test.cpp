#include "simulation/contact/contact_extent.h"

#include <gtest/gtest.h>

#include <cmath>

#include "parallel/parallel.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/published/planted_penetrations.h"

namespace ribbon::contact_extent_test {

using Eigen::Matrix3Xd;

constexpr RibbonGrid grid{21, 5};
constexpr RestSize size{grid, 20, 4};  // edges of 1 m: contact begins at 0.2 m, touch at 0.3 m
const PairDistances distances(size, contact_lengths(1, 0, 0));

ContactExtent extent_alone(const Matrix3Xd& positions) {
  Bodies bodies = ribbon_alone(grid);
  return contact_extent(bodies, size, distances, positions);
}

TEST(ContactExtent, of_a_flat_ribbon_is_nothing) {
  const ContactExtent extent = extent_alone(flat_ribbon(grid));
  EXPECT_EQ(extent.share, 0);
  EXPECT_EQ(extent.knotted_m, 0);
}

// Rows, or columns, slide past each other until they are 0.2 m apart.
TEST(ContactExtent, of_a_ribbon_that_is_only_sheared_is_nothing) {
  const double aside = std::sin(0.2);
  const double along = std::cos(0.2);
  Matrix3Xd rows_slide = flat_ribbon(grid);
  Matrix3Xd columns_slide = rows_slide;
  for (int p = 0; p < grid.particle_count(); ++p) {
    rows_slide.col(p) << aside * grid.row(p), 0, grid.column(p) + along * grid.row(p);
    columns_slide.col(p) << grid.row(p) + along * grid.column(p), 0, aside * grid.column(p);
  }
  for (const Matrix3Xd& sheared : {rows_slide, columns_slide}) {
    EXPECT_EQ(extent_alone(sheared).share, 0);
    EXPECT_EQ(extent_alone(sheared).knotted_m, 0);
  }
}

TEST(ContactExtent, on_the_obstacle_is_contact_but_no_knot) {
  OverFloor near = ribbon_over_floor(grid, -0.29);
  const ContactExtent touching = contact_extent(near.bodies, size, distances, near.positions);
  EXPECT_EQ(touching.share, 1);
  EXPECT_EQ(touching.knotted_m, 0);
  OverFloor far = ribbon_over_floor(grid, -0.31);
  EXPECT_EQ(contact_extent(far.bodies, size, distances, far.positions).share, 0);
}

// By hand: rows 10 to 20 return over rows 9.5 to -0.5, so that all but row 10, at the fold, lies
// double.
TEST(ContactExtent, of_a_fold_reaches_from_its_first_to_its_last_row) {
  const ContactExtent extent = extent_alone(folded_ribbon(grid, 0.25));
  EXPECT_NEAR(extent.share, 20.0 / 21, 1e-12);
  EXPECT_DOUBLE_EQ(extent.knotted_m, 20);
}

// By hand: the last row stands 0.25 m over row 5, all else is free. What touches does so with all
// of its corners: rows 19 and 20, and 4 to 6.
TEST(ContactExtent, counts_the_rows_in_between_as_knotted_but_not_as_touching) {
  Matrix3Xd positions = flat_ribbon(grid);
  for (int p = 0; p < grid.particle_count(); ++p)
    if (grid.row(p) > 5) positions(1, p) = 20;
  for (int j = 0; j < grid.across; ++j) positions.col(grid.particle(20, j)) << 5, 0.25, j + 0.5;
  const ContactExtent extent = extent_alone(positions);
  EXPECT_NEAR(extent.share, 5.0 / 21, 1e-12);
  EXPECT_DOUBLE_EQ(extent.knotted_m, 16);
}

// Many parts of the ribbon are looked at, in whatever order.
TEST(ContactExtent, of_a_long_fold_is_the_same_with_any_number_of_threads) {
  constexpr RibbonGrid long_grid{401, 9};
  constexpr RestSize long_size{long_grid, 400, 8};
  const PairDistances apart(long_size, contact_lengths(1, 0, 0));
  const Matrix3Xd positions = folded_ribbon(long_grid, 0.25);
  Bodies bodies = ribbon_alone(long_grid);
  for (const int threads : {1, 2, 0}) {
    set_thread_limit(threads);
    const ContactExtent extent = contact_extent(bodies, long_size, apart, positions);
    EXPECT_NEAR(extent.share, 400.0 / 401, 1e-12) << threads;
    EXPECT_DOUBLE_EQ(extent.knotted_m, 400) << threads;
  }
  set_thread_limit(0);
}

}  // namespace ribbon::contact_extent_test

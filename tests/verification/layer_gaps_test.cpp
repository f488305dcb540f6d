#include "verification/layer_gaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/solids.h"
#include "verification/feature_distance.h"
#include "verification/frame_verifier.h"

namespace ribbon::layer_gaps_test {

constexpr double nothing = std::numeric_limits<double>::infinity();

// 21 rows and 3 columns, 1 m apart at rest.
constexpr RibbonGrid grid{21, 3};

FrameVerifier verifier(const std::optional<TriangleMesh>& obstacle = std::nullopt) {
  return FrameVerifier({grid, 20, 2}, obstacle);
}

// Row i at (x, y) of profile(i), columns along z.
template <class Profile>
Eigen::Matrix3Xf ribbon_along(const Profile& profile) {
  Eigen::Matrix3Xf positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const Eigen::Vector2f place = profile(grid.row(p));
    positions.col(p) << place.x(), place.y(), static_cast<float>(grid.column(p));
  }
  return positions;
}

Eigen::Matrix3Xf flat() {
  return ribbon_along([](int row) { return Eigen::Vector2f(static_cast<float>(row), 0); });
}

// Folded in the middle: rows 0 to 9 lie below rows 11 to 20, `apart` away.
Eigen::Matrix3Xf folded(float apart) {
  return ribbon_along([apart](int row) {
    return Eigen::Vector2f(static_cast<float>(row < 10   ? row
                                              : row > 10 ? 20 - row
                                                         : 10),
                           row < 10   ? 0
                           : row > 10 ? apart
                                      : apart / 2);
  });
}

TEST(LayerGaps, a_flat_ribbon_has_no_other_layer) {
  const FrameVerifier flat_verifier = verifier();
  const LayerGaps gaps = flat_verifier.layer_gaps(flat());
  for (int p = 0; p < grid.particle_count(); ++p) {
    EXPECT_EQ(gaps.at(p, 100).to_ribbon_m, nothing);
    EXPECT_EQ(gaps.at(p, 100).to_obstacle_m, nothing);
  }
}

TEST(LayerGaps, parallel_layers_are_as_far_apart_as_they_were_laid) {
  const FrameVerifier folded_verifier = verifier();
  const LayerGaps gaps = folded_verifier.layer_gaps(folded(0.25F));
  for (const int row : {0, 3, 8, 12, 20})
    for (int column = 0; column < grid.across; ++column)
      EXPECT_NEAR(gaps.at(grid.particle(row, column), 1).to_ribbon_m, 0.25, 1e-12) << row;
}

TEST(LayerGaps, what_is_beyond_reach_is_not_there) {
  const FrameVerifier folded_verifier = verifier();
  const LayerGaps gaps = folded_verifier.layer_gaps(folded(0.25F));
  EXPECT_EQ(gaps.at(0, 0.24).to_ribbon_m, nothing);
  EXPECT_NEAR(gaps.at(0, 0.25).to_ribbon_m, 0.25, 1e-12);
}

TEST(LayerGaps, what_is_half_as_far_as_at_rest_is_another_layer_from_there_on) {
  // Rows 1 and 19 face each other, 18 m apart at rest: 17 m from one to the other's nearest quad.
  const FrameVerifier folded_verifier = verifier();
  const int particle = grid.particle(1, 1);
  EXPECT_NEAR(folded_verifier.layer_gaps(folded(8.4F)).at(particle, 100).to_ribbon_m, 8.4, 1e-6);
  EXPECT_GT(folded_verifier.layer_gaps(folded(9.6F)).at(particle, 100).to_ribbon_m, 9.6);
}

// Columns are 0.1 m apart in the first row: less than half of their mean distance, and no gap.
TEST(LayerGaps, of_a_ribbon_with_a_profile_its_narrow_part_is_no_other_layer) {
  RestSize tapered{grid, 20, 2};
  for (int row = 0; row < grid.along; ++row) tapered.row_widths_m.push_back(0.2 + 0.18 * row);
  Eigen::Matrix3Xf flat(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p)
    flat.col(p) << tapered.place_m(p).cast<float>(), 0;
  const FrameVerifier of_profile(tapered);
  const FrameVerifier of_mean({grid, 20, 2});
  EXPECT_EQ(of_profile.layer_gaps(flat).at(0, 10).to_ribbon_m, nothing);
  EXPECT_LT(of_mean.layer_gaps(flat).at(0, 10).to_ribbon_m, 0.2);
}

TEST(LayerGaps, the_obstacle_is_measured_by_itself) {
  const FrameVerifier on_table =
      verifier(quad_mesh({-5, -0.5F, -5}, {-5, -0.5F, 5}, {25, -0.5F, 5}, {25, -0.5F, -5}));
  const LayerGap gap = on_table.layer_gaps(folded(0.25F)).at(grid.particle(15, 1), 10);
  EXPECT_NEAR(gap.to_ribbon_m, 0.25, 1e-12);
  EXPECT_NEAR(gap.to_obstacle_m, 0.75, 1e-12);
}

// Every triangle in turn, of a ribbon that is wound up and shaken.
TEST(LayerGaps, are_those_that_measuring_every_triangle_finds) {
  Eigen::Matrix3Xf positions = ribbon_along([](int row) {
    const float angle = 0.9F * static_cast<float>(row);
    const float radius = 1 + 0.15F * angle;
    return Eigen::Vector2f(radius * std::cos(angle), radius * std::sin(angle));
  });
  for (Eigen::Index k = 0; k < positions.size(); ++k)
    positions.data()[k] += 0.1F * std::sin(1000 * static_cast<float>(k));
  const FrameVerifier wound = verifier();
  const TriangleSoup soup = wound.soup(positions);
  const LayerGaps gaps = wound.layer_gaps(positions);
  int found = 0;
  for (int p = 0; p < grid.particle_count(); ++p) {
    double nearest = nothing;
    for (int t = 0; t < grid.triangle_count(); ++t) {
      const double distance = certain_point_triangle_distance(soup.points.col(p), soup.corner(t, 0),
                                                              soup.corner(t, 1), soup.corner(t, 2));
      const double rows = std::max({0, t / 4 - grid.row(p), grid.row(p) - t / 4 - 1});
      const double columns =
          std::max({0, t / 2 % 2 - grid.column(p), grid.column(p) - t / 2 % 2 - 1});
      if (distance < std::hypot(rows, columns) / 2) nearest = std::min(nearest, distance);
    }
    EXPECT_EQ(gaps.at(p, 100).to_ribbon_m, nearest) << "particle " << p;
    found += nearest < nothing ? 1 : 0;
  }
  EXPECT_GT(found, 20);
}

}  // namespace ribbon::layer_gaps_test

#include "player/render/sampling.h"

#include <gtest/gtest.h>

#include <set>

namespace ribbon::sampling_test {

TEST(SamplePatterns, sixteen_points_fill_every_kind_of_sixteenth) {
  const SamplePatterns patterns(16);
  for (const Pattern pattern : {Pattern::pixel, Pattern::sun, Pattern::sky})
    for (const std::uint32_t key : {0U, 0x9E3779B9U})
      for (const int columns : {1, 2, 4, 8, 16}) {
        const int rows = 16 / columns;
        std::set<int> cells;
        for (int s = 0; s < 16; ++s) {
          const Eigen::Vector2f point = patterns.point(pattern, s, key, ~key);
          EXPECT_GE(point.minCoeff(), 0);
          EXPECT_LT(point.maxCoeff(), 1);
          cells.insert(static_cast<int>(point.x() * static_cast<float>(columns)) * rows +
                       static_cast<int>(point.y() * static_cast<float>(rows)));
        }
        EXPECT_EQ(cells.size(), 16U) << columns << " columns";
      }
}

TEST(SamplePatterns, the_first_sixteen_of_many_fill_every_kind_of_sixteenth) {
  const SamplePatterns patterns(256);
  std::set<int> cells;
  for (int s = 0; s < 16; ++s) {
    const Eigen::Vector2f point = patterns.point(Pattern::sky, s, 7, 9);
    cells.insert(static_cast<int>(point.x() * 4) * 4 + static_cast<int>(point.y() * 4));
  }
  EXPECT_EQ(cells.size(), 16U);
}

TEST(SamplePatterns, patterns_do_not_know_each_other) {
  const SamplePatterns patterns(256);
  double covariance = 0;
  for (int s = 0; s < 256; ++s)
    covariance += (patterns.point(Pattern::sun, s, 0, 0).x() - 0.5) *
                  (patterns.point(Pattern::sky, s, 0, 0).x() - 0.5);
  EXPECT_LT(std::abs(covariance / 256), 0.25 / 12);
}

TEST(SamplePatterns, the_same_each_time) {
  for (const int samples : {1, 5, 16})
    for (int s = 0; s < samples; ++s)
      EXPECT_EQ(SamplePatterns(samples).point(Pattern::sky, s, 1, 2),
                SamplePatterns(samples).point(Pattern::sky, s, 1, 2));
}

}  // namespace ribbon::sampling_test

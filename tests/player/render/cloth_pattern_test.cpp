#include "player/render/cloth_pattern.h"

#include <gtest/gtest.h>

#include <vector>

namespace ribbon::cloth_pattern_test {

// From `first` to `last`, both included, in `steps` equal steps.
std::vector<float> from_to(float first, float last, int steps) {
  std::vector<float> samples;
  for (int i = 0; i <= steps; ++i)
    samples.push_back(first + (last - first) * static_cast<float>(i) / static_cast<float>(steps));
  return samples;
}

float difference(const Color& a, const Color& b) {
  return (a - b).abs().maxCoeff();
}

TEST(ClothPattern, front_and_back_differ_everywhere) {
  for (const float along : from_to(0, 3, 230))
    for (const float across : from_to(0, 1, 100))
      EXPECT_GT(difference(cloth_front(along, across, 0), cloth_back(along, across, 0)), 0.1F);
}

TEST(ClothPattern, both_selvages_have_a_stripe) {
  EXPECT_LT(difference(cloth_front(0.3F, 0.05F, 0), cloth_front(7.1F, 0.95F, 0)), 1e-6F);
  EXPECT_GT(difference(cloth_back(0, 0.05F, 0), cloth_back(0, 0.5F, 0)), 0.1F);
}

TEST(ClothPattern, the_front_shows_which_way_it_runs) {
  // Within one disc the arcs bulge towards the second end: mirrored, the pattern is another one.
  int differing = 0;
  for (const float along : from_to(0.005F, 0.995F, 99))
    if (difference(cloth_front(2 + along, 0.4F, 0), cloth_front(2 - along, 0.4F, 0)) > 0.1F)
      ++differing;
  EXPECT_GT(differing, 15);
}

TEST(ClothPattern, returns_less_light_than_it_gets) {
  for (const float along : from_to(0, 2, 200))
    for (const float across : from_to(0, 1, 100))
      for (const Color& color : {cloth_front(along, across, 0), cloth_back(along, across, 0)}) {
        EXPECT_GT(color.minCoeff(), 0);
        EXPECT_LT(color.maxCoeff(), 0.9F);
      }
}

TEST(ClothPattern, a_wide_look_sees_the_mean_of_what_is_fine) {
  Color mean = Color::Zero();
  int count = 0;
  for (const float along : from_to(3, 4, 300))
    for (const float across : from_to(0.3F, 0.7F, 120)) {
      mean += cloth_front(along, across, 0);
      ++count;
    }
  mean /= static_cast<float>(count);
  EXPECT_LT(difference(cloth_front(3.2F, 0.5F, 0.2F), mean), 0.03F);
}

}  // namespace ribbon::cloth_pattern_test

#include "simulation/truncation/chain_tensions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace ribbon::chain_tensions_test {

using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;

constexpr double none = std::numeric_limits<double>::infinity();

std::vector<double> found(ChainTensions& chain, const std::vector<double>& slack,
                          const std::vector<double>& cosines, double tight = 0) {
  const auto tensions = chain.find(slack, cosines, tight);
  return {tensions.begin(), tensions.end()};
}

// What is left of each link's slack.
std::vector<double> left_of(const std::vector<double>& slack, const std::vector<double>& cosines,
                            const std::vector<double>& weights,
                            const std::vector<double>& tensions) {
  std::vector<double> left(slack.size());
  for (std::size_t i = 0; i < slack.size(); ++i) {
    left[i] = slack[i] + (weights[i] + weights[i + 1]) * tensions[i];
    if (i > 0) left[i] -= weights[i] * cosines[i - 1] * tensions[i - 1];
    if (i + 1 < slack.size()) left[i] -= weights[i + 1] * cosines[i] * tensions[i + 1];
  }
  return left;
}

TEST(ChainTensions, share_what_one_link_is_too_long_by_weight) {
  ChainTensions chain({1, 3});
  EXPECT_THAT(found(chain, {-0.4}, {}), ElementsAre(DoubleNear(0.1, 1e-15)));
}

TEST(ChainTensions, are_none_where_nothing_is_too_long) {
  ChainTensions chain({1, 1, 1});
  EXPECT_THAT(found(chain, {0.1, 0}, {1}, 1), Each(0));
}

// By hand: all links but the first are just as long as they may; four bodies follow the fifth.
TEST(ChainTensions, draw_all_that_is_taut_behind_one_body) {
  ChainTensions chain({1, 1, 1, 1, 1});
  for (const double tight : {0.0, 0.1})
    EXPECT_THAT(found(chain, {-0.5, 0, 0, 0}, {1, 1, 1}, tight),
                ElementsAre(DoubleNear(0.4, 1e-14), DoubleNear(0.3, 1e-14), DoubleNear(0.2, 1e-14),
                            DoubleNear(0.1, 1e-14)))
        << tight;
}

TEST(ChainTensions, end_where_a_link_has_room) {
  ChainTensions chain({1, 1, 1, 1});
  EXPECT_THAT(found(chain, {-0.2, 1, -0.4}, {1, 1}, 0.5),
              ElementsAre(DoubleNear(0.1, 1e-15), 0, DoubleNear(0.2, 1e-15)));
}

TEST(ChainTensions, do_not_pass_where_nothing_joins) {
  ChainTensions chain({1, 1, 1});
  EXPECT_THAT(found(chain, {-0.2, none}, {std::nan("")}, 1),
              ElementsAre(DoubleNear(0.1, 1e-15), 0));
}

// Of chains that wind at random: no link too long, none that pushes, none slack under tension.
TEST(ChainTensions, solve_the_complementarity_problem) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> weight(0.3, 3);
  std::uniform_real_distribution<double> slack(-0.1, 0.3);
  std::uniform_real_distribution<double> cosine(0.2, 1);
  for (int chain_number = 0; chain_number < 200; ++chain_number) {
    std::vector<double> weights(60);
    std::vector<double> slacks(59);
    std::vector<double> cosines(59);
    for (double& of_one : weights) of_one = weight(random);
    for (double& of_one : slacks) of_one = slack(random);
    for (double& of_one : cosines) of_one = cosine(random);
    ChainTensions chain(weights);
    const std::vector<double> tensions = found(chain, slacks, cosines, 0.05);
    const std::vector<double> left = left_of(slacks, cosines, weights, tensions);
    for (std::size_t i = 0; i < tensions.size(); ++i) {
      EXPECT_GE(tensions[i], 0) << i;
      EXPECT_GE(left[i], -1e-13) << i;
      EXPECT_LE(tensions[i] * left[i], 1e-13) << i;
    }
  }
}

}  // namespace ribbon::chain_tensions_test

#include "simulation/truncation/pairs_of_particles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace ribbon::pairs_of_particles_test {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = FeaturePair::Kind;

TEST(PairsOfParticles, are_those_that_have_it_in_order) {
  const std::vector<FeaturePair> pairs = {{Kind::edge_edge, {0, 1, 2, 3}},
                                          {Kind::vertex_triangle, {3, 7, 8, 9}},
                                          {Kind::edge_edge, {3, 2, 7, 9}}};
  PairsOfParticles of;
  of.sort(pairs, 5);
  EXPECT_THAT(of[0], ElementsAre(0));
  EXPECT_THAT(of[2], ElementsAre(0, 2));
  EXPECT_THAT(of[3], ElementsAre(0, 1, 2));
  EXPECT_THAT(of[4], IsEmpty());
}

TEST(PairsOfParticles, are_those_of_the_last_list) {
  PairsOfParticles of;
  of.sort(std::vector<FeaturePair>{{Kind::edge_edge, {0, 1, 2, 3}}}, 4);
  of.sort(std::vector<FeaturePair>{{Kind::edge_edge, {4, 1, 5, 3}}}, 6);
  EXPECT_THAT(of[0], IsEmpty());
  EXPECT_THAT(of[5], ElementsAre(0));
}

}  // namespace ribbon::pairs_of_particles_test

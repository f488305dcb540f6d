#include "geometry/lengths_along.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ribbon::lengths_along_test {

using testing::ElementsAre;

// By hand: 3-4-5 and 5-12-13.
TEST(LengthsAlong, add_up_from_the_first_point) {
  using Points = std::vector<Eigen::Vector2d>;
  EXPECT_THAT(lengths_along(Points{{1, 2}, {4, 6}, {4, 6}, {-8, 11}}), ElementsAre(0, 5, 5, 18));
  EXPECT_THAT(lengths_along(Points{{1, 2}}), ElementsAre(0));
}

}  // namespace ribbon::lengths_along_test

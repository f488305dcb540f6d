#include "geometry/first_in_place.h"

#include <gmock/gmock.h>

namespace ribbon::first_in_place_test {

TEST(FirstInPlace, is_the_vertex_itself_or_one_before_that_is_exactly_there) {
  Eigen::Matrix3Xf vertices(3, 5);
  vertices << 0, 1, 0, 1, 0,   //
      0, 0, -0.0F, 0, 1e-30F,  //
      2, 2, 2, 2, 2;
  EXPECT_THAT(first_in_place(vertices), testing::ElementsAre(0, 1, 0, 1, 4));
  EXPECT_TRUE(first_in_place(Eigen::Matrix3Xf(3, 0)).empty());
}

}  // namespace ribbon::first_in_place_test

#include "simulation/fastening/carried_place.h"

#include <gtest/gtest.h>

#include "result/refusal.h"

namespace ribbon::carried_place_test {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// 3 m straight to a way of 4 m and 5 m with a corner.
CarriedPlace on_a_way() {
  Matrix3Xd way(3, 3);
  way << 3, 3, 3,  //
      0, 4, 4,     //
      0, 0, 5;
  return {Vector3d::Zero(), way};
}

TEST(CarriedPlace, goes_to_the_way_and_along_it_round_corners) {
  CarriedPlace place = on_a_way();
  EXPECT_EQ(place.now(), Vector3d(0, 0, 0));
  place.go_on(1.5);
  EXPECT_EQ(place.now(), Vector3d(1.5, 0, 0));
  place.go_on(1.5);
  EXPECT_EQ(place.now(), Vector3d(3, 0, 0));
  place.go_on(3);
  EXPECT_EQ(place.now(), Vector3d(3, 3, 0));
  place.go_on(2);
  EXPECT_EQ(place.now(), Vector3d(3, 4, 1));
}

TEST(CarriedPlace, stays_at_the_end_of_its_way) {
  CarriedPlace place = on_a_way();
  place.go_on(11.9);
  EXPECT_FALSE(place.has_arrived());
  place.go_on(7);
  EXPECT_TRUE(place.has_arrived());
  EXPECT_EQ(place.now(), Vector3d(3, 4, 5));
}

TEST(CarriedPlace, a_way_without_length_is_gone_at_once) {
  const CarriedPlace place(Vector3d(1, 2, 3), Matrix3Xd(Vector3d(1, 2, 3).replicate(1, 2)));
  EXPECT_TRUE(place.has_arrived());
  EXPECT_EQ(place.now(), Vector3d(1, 2, 3));
}

TEST(CarriedPlace, goes_on_from_its_state_and_from_no_other) {
  CarriedPlace place = on_a_way();
  place.go_on(6);
  StateArchive written;
  place.visit_state(written);
  CarriedPlace restored = on_a_way();
  StateArchive read(written.bytes());
  restored.visit_state(read);
  EXPECT_EQ(refusal_of(read.finish()), "");
  EXPECT_EQ(restored.now(), Vector3d(3, 3, 0));

  StateArchive negative;
  double before_m = -1;
  negative.visit(before_m);
  StateArchive wrong(negative.bytes());
  restored.visit_state(wrong);
  EXPECT_THAT(refusal_of(wrong.finish()), HasSubstr("before its begin"));
  EXPECT_EQ(restored.now(), Vector3d(3, 3, 0));
}

}  // namespace ribbon::carried_place_test

#include "converter/comparison.h"

#include <gtest/gtest.h>

#include "converter/output_verification.h"

namespace ribbon::comparison_test {

// One frame.
Deviations found(int frame, double largest_m, double allowed_m) {
  return {.frames = 1,
          .within = largest_m <= allowed_m,
          .largest_m = largest_m,
          .frame = frame,
          .allowed_m = allowed_m,
          .difference = ""};
}

Deviations all_of(const std::vector<Deviations>& parts) {
  Deviations all;
  for (const Deviations& part : parts) all.add(part);
  return all;
}

TEST(Deviations, tell_the_largest_where_all_are_within) {
  const Deviations all = all_of({found(1, 1e-6, 2e-6), found(2, 3e-6, 4e-6), found(3, 0, 0)});
  EXPECT_TRUE(all.within);
  EXPECT_EQ(all.frame, 2);
  EXPECT_EQ(all.frames, 3);
}

TEST(Deviations, tell_the_worst_of_those_that_are_not_within) {
  const Deviations far = found(1, 3e-6, 4e-6);
  const Deviations little_beyond = found(2, 2e-6, 1.9e-6);
  const Deviations beyond = found(3, 1e-6, 1e-7);
  for (const Deviations& all :
       {all_of({far, little_beyond, beyond}), all_of({beyond, little_beyond, far})}) {
    EXPECT_FALSE(all.within);
    EXPECT_EQ(all.frame, 3);
    EXPECT_EQ(verification_text({".obj", "a reader", all}),
              ".obj as a reader reads it, 3 frames: 1e-06 m from the recording, in frame 3; only "
              "1e-07 m is allowed");
  }
}

TEST(Deviations, name_the_first_of_equals_and_a_frame_before_the_obstacle) {
  EXPECT_EQ(all_of({found(0, 0, 0), found(4, 0, 0), found(5, 0, 0), found(0, 0, 0)}).frame, 4);
}

}  // namespace ribbon::comparison_test

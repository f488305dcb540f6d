#include "simulation/truncation/sweep_activity.h"

#include <gtest/gtest.h>

namespace ribbon::sweep_activity_test {

TEST(SweepActivity, nothing_rests_before_a_task_has_looked_at_it) {
  SweepActivity activity({3, 1}, 2);
  for (const std::size_t task : {0U, 1U}) {
    activity.begin(task);
    for (int row = 0; row < 3; ++row) EXPECT_FALSE(activity.is_resting(row));
  }
}

TEST(SweepActivity, rows_rest_until_somebody_moves_them) {
  SweepActivity activity({3, 1}, 2);
  activity.begin(0);
  activity.begin(1);
  activity.begin(0);
  for (int row = 0; row < 3; ++row) EXPECT_TRUE(activity.is_resting(row));
  activity.move(1, 0.5);
  EXPECT_FALSE(activity.is_resting(1));
  activity.begin(1);
  EXPECT_TRUE(activity.is_resting(0));
  EXPECT_FALSE(activity.is_resting(1));
}

// An edge may be looked at before a later one of the same turn moves its end.
TEST(SweepActivity, what_moved_in_a_turn_is_looked_at_in_the_next_of_the_same_task) {
  SweepActivity activity({3, 1}, 1);
  activity.begin(0);
  activity.move(2, 0.5);
  activity.begin(0);
  EXPECT_TRUE(activity.is_resting(1));
  EXPECT_FALSE(activity.is_resting(2));
  activity.begin(0);
  EXPECT_TRUE(activity.is_resting(2));
}

TEST(SweepActivity, adds_up_how_far_vertices_have_moved_since_the_last_reset) {
  const RibbonGrid grid{3, 2};
  const int of_the_obstacle = grid.particle_count();
  SweepActivity activity(grid, 1);
  activity.move(2, 0.5);
  activity.move(2, 0.25);
  activity.move(5, 2);
  EXPECT_EQ(activity.travelled_m({2, 0, 1, of_the_obstacle}), 0.75);
  EXPECT_EQ(activity.travelled_m({5, of_the_obstacle, 3, 2}), 2.75);
  activity.reset();
  EXPECT_EQ(activity.travelled_m({2, 5, 0, 1}), 0);
}

}  // namespace ribbon::sweep_activity_test

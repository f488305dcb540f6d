#include "simulation/truncation/row_activity.h"

#include <gtest/gtest.h>

namespace ribbon::row_activity_test {

TEST(RowActivity, nothing_rests_before_a_task_has_looked_at_it) {
  RowActivity activity(3, 2);
  for (const std::size_t task : {0U, 1U}) {
    activity.begin(task);
    for (int row = 0; row < 3; ++row) EXPECT_FALSE(activity.is_resting(row));
  }
}

TEST(RowActivity, rows_rest_until_somebody_moves_them) {
  RowActivity activity(3, 2);
  activity.begin(0);
  activity.begin(1);
  activity.begin(0);
  for (int row = 0; row < 3; ++row) EXPECT_TRUE(activity.is_resting(row));
  activity.move(1);
  EXPECT_FALSE(activity.is_resting(1));
  activity.begin(1);
  EXPECT_TRUE(activity.is_resting(0));
  EXPECT_FALSE(activity.is_resting(1));
}

// An edge may be looked at before a later one of the same turn moves its end.
TEST(RowActivity, what_moved_in_a_turn_is_looked_at_in_the_next_of_the_same_task) {
  RowActivity activity(3, 1);
  activity.begin(0);
  activity.move(2);
  activity.begin(0);
  EXPECT_TRUE(activity.is_resting(1));
  EXPECT_FALSE(activity.is_resting(2));
  activity.begin(0);
  EXPECT_TRUE(activity.is_resting(2));
}

}  // namespace ribbon::row_activity_test

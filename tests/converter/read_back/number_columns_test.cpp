#include "converter/read_back/number_columns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "converter/read_back/written_motion.h"

namespace ribbon::number_columns_test {

TEST(NumberColumns, stand_one_after_the_other) {
  EXPECT_EQ(columns({1, 2, 3, 4}, 2), (Eigen::Matrix2d() << 1, 3, 2, 4).finished());
  EXPECT_THROW(columns({1, 2, 3}, 2), Spoiled);
}

TEST(NumberColumns, are_whole_where_an_int_can_hold_them) {
  const double least = std::numeric_limits<int>::min();
  const double most = std::numeric_limits<int>::max();
  EXPECT_EQ(whole_columns({least, most}, 1), Eigen::RowVector2i(least, most));
  for (const double number : {least - 1, most + 1, 1e300, -1e300, std::nan("")})
    EXPECT_THROW(whole_columns({number}, 1), Spoiled) << number;
}

}  // namespace ribbon::number_columns_test

#include "simulation/integration/ordered_sums.h"

#include <gtest/gtest.h>

#include <vector>

namespace ribbon::ordered_sums_test {

TEST(OrderedSums, leave_nothing_out_however_many_there_are) {
  for (int count = 0; count < 20; ++count) {
    std::vector<double> a(count);
    std::vector<double> b(count);
    double sum = 0;
    double products = 0;
    for (int i = 0; i < count; ++i) {
      a[i] = i + 1;
      b[i] = 3 * i - 7;
      sum += a[i];
      products += a[i] * b[i];
    }
    EXPECT_EQ(sum_of(a.data(), count), sum);
    EXPECT_EQ(sum_of_products(a.data(), b.data(), count), products);
  }
}

// What is added late to much is lost: that shows the order.
TEST(OrderedSums, every_fourth_goes_together) {
  const std::vector<double> numbers = {1e16, 1, 1, 1, -1e16, 1, 1, 1, 1};
  EXPECT_EQ(sum_of(numbers.data(), 9), 7);
  const std::vector<double> beside = {1e16, -1e16, 1, 1, 1, 1, 1, 1};
  EXPECT_EQ(sum_of(beside.data(), 8), 4) << "1 is lost in 1e16";
}

TEST(OrderedSums, of_matrices_are_of_all_entries) {
  const Eigen::MatrixX3d a{{1, 2, 3}, {4, 5, 6}, {7, 8, 12}};
  EXPECT_EQ(sum_of_squares(a), 348);
  EXPECT_EQ(sum_of_products(a, Eigen::MatrixX3d::Constant(3, 3, 2)), 96);
  EXPECT_EQ(mean_of_rows(a), Eigen::RowVector3d(4, 5, 7));
}

}  // namespace ribbon::ordered_sums_test

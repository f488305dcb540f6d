#include "simulation/integration/ordered_sums.h"

#include <gtest/gtest.h>

#include <vector>

namespace ribbon::ordered_sums_test {

TEST(OrderedSums, leave_nothing_out_however_many_there_are) {
  for (int count = 0; count < 50; ++count) {
    std::vector<double> a(count);
    std::vector<double> b(count);
    std::vector<double> c(count);
    double sum = 0;
    double products = 0;
    double of_three = 0;
    for (int i = 0; i < count; ++i) {
      a[i] = i + 1;
      b[i] = 3 * i - 7;
      c[i] = i % 4;
      sum += a[i];
      products += a[i] * b[i];
      of_three += a[i] * b[i] * c[i];
    }
    EXPECT_EQ(sum_of(a.data(), count), sum);
    EXPECT_EQ(sum_of_products(a.data(), b.data(), count), products);
    EXPECT_EQ(sum_of_products(a.data(), b.data(), c.data(), count), of_three);
  }
}

// What is added late to much is lost: that shows the order.
TEST(OrderedSums, every_sixteenth_goes_together) {
  std::vector<double> numbers(33, 1);
  numbers[0] = 1e16;
  numbers[16] = -1e16;
  EXPECT_EQ(sum_of(numbers.data(), 33), 31);
  std::vector<double> beside(32, 1);
  beside[0] = 1e16;
  beside[1] = -1e16;
  EXPECT_EQ(sum_of(beside.data(), 32), 28) << "what lies sixteen from 1e16 is lost in it";
}

TEST(OrderedSums, of_matrices_are_of_all_entries) {
  const Eigen::MatrixX3d a{{1, 2, 3}, {4, 5, 6}, {7, 8, 12}};
  EXPECT_EQ(sum_of_squares(a), 348);
  EXPECT_EQ(sum_of_products(a, Eigen::MatrixX3d::Constant(3, 3, 2)), 96);
  EXPECT_EQ(sum_of_products(a, a, 1, 2), 348 - 14) << "of the last two rows";
  EXPECT_EQ(mean_of_rows(a), Eigen::RowVector3d(4, 5, 7));
}

}  // namespace ribbon::ordered_sums_test

#include "simulation/integration/ordered_sums.h"

#include <array>
#include <cstring>

#include "simulation/integration/fours.h"

namespace ribbon {

namespace {

using Eigen::Index;

// Several sums of four at a time: none waits for the one before it.
constexpr Index four_count = 4;

// Of the products of as many numbers at each address.
template <class... Numbers>
double sum_in_lanes(Index count, const Numbers*... factors) {
  std::array<Four, four_count> sums{};
  Index i = 0;
  for (; i + 4 * four_count <= count; i += 4 * four_count)
    for (Index four = 0; four < four_count; ++four) {
      Four product = Four{} + 1;
      const auto multiply = [&](const double* numbers) {
        Four factor{};
        std::memcpy(&factor, numbers + i + 4 * four, sizeof(factor));
        product *= factor;
      };
      (multiply(factors), ...);
      sums[four] += product;
    }
  for (Index lane = 0; i < count; ++i, ++lane) sums[lane / 4][lane % 4] += (factors[i] * ...);
  const Four sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace

double sum_of_products(const double* a, const double* b, Index count) {
  return sum_in_lanes(count, a, b);
}

double sum_of_products(const double* a, const double* b, const double* c, Index count) {
  return sum_in_lanes(count, a, b, c);
}

double sum_of(const double* numbers, Index count) {
  return sum_in_lanes(count, numbers);
}

double sum_of_products(const Eigen::MatrixX3d& a, const Eigen::MatrixX3d& b, Index first,
                       Index count) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    sum += sum_of_products(a.col(axis).data() + first, b.col(axis).data() + first, count);
  return sum;
}

Eigen::RowVector3d mean_of_rows(const Eigen::MatrixX3d& rows) {
  Eigen::RowVector3d mean;
  for (int axis = 0; axis < 3; ++axis)
    mean[axis] = sum_of(rows.col(axis).data(), rows.rows()) / static_cast<double>(rows.rows());
  return mean;
}

}  // namespace ribbon

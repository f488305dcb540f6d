#include "simulation/integration/lbfgs_history.h"

#include <algorithm>

#include "simulation/integration/ordered_sums.h"

namespace ribbon {

using Eigen::MatrixX3d;

void LbfgsHistory::add(const MatrixX3d& displacement, const MatrixX3d& gradient_change,
                       double least_curvature) {
  const double product = sum_of_products(displacement, gradient_change);
  if (!(product > least_curvature * sum_of_squares(displacement))) return;
  Pair& oldest = pairs_[next_];
  oldest.displacement = displacement;
  oldest.gradient_change = gradient_change;
  oldest.product = product;
  next_ = (next_ + 1) % most_pairs;
  count_ = std::min(count_ + 1, most_pairs);
}

// The two loops of Nocedal, "Updating quasi-Newton matrices with limited storage", 1980.
void LbfgsHistory::toward_minimum(QuasiNewtonMatrix& matrix, MatrixX3d& negative_gradient,
                                  MatrixX3d& displacement) const {
  std::array<double, most_pairs> alpha{};
  for (int age = 0; age < count_; ++age) {
    alpha[age] = sum_of_products(pair(age).displacement, negative_gradient) / pair(age).product;
    negative_gradient -= alpha[age] * pair(age).gradient_change;
  }
  matrix.solve(negative_gradient, displacement);
  for (int age = count_ - 1; age >= 0; --age) {
    const double beta =
        sum_of_products(pair(age).gradient_change, displacement) / pair(age).product;
    displacement += (alpha[age] - beta) * pair(age).displacement;
  }
}

}  // namespace ribbon

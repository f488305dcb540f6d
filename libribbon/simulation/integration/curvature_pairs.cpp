#include "simulation/integration/curvature_pairs.h"

#include <algorithm>

#include "simulation/integration/flat_state.h"

namespace ribbon {

namespace {

using Eigen::MatrixX3d;

}  // namespace

void CurvaturePairs::learn(const MatrixX3d& displacement, const MatrixX3d& gradient_change,
                           double least_curvature) {
  const double product = dot(displacement, gradient_change);
  if (!(product > least_curvature * displacement.squaredNorm())) return;
  Pair& oldest = pairs_[static_cast<std::size_t>(next_)];
  oldest.displacement = displacement;
  oldest.gradient_change = gradient_change;
  oldest.product = product;
  next_ = (next_ + 1) % most_pairs;
  count_ = std::min(count_ + 1, most_pairs);
}

// The two loops of Nocedal, "Updating quasi-Newton matrices with limited storage", 1980.
void CurvaturePairs::toward_minimum(MatrixX3d& negative_gradient, const Solve& solve,
                                    MatrixX3d& displacement) const {
  std::array<double, most_pairs> share{};
  for (int age = 0; age < count_; ++age) {
    const Pair& known = pair(age);
    double& alpha = share[static_cast<std::size_t>(age)];
    alpha = dot(known.displacement, negative_gradient) / known.product;
    negative_gradient -= alpha * known.gradient_change;
  }
  solve(negative_gradient, displacement);
  for (int age = count_ - 1; age >= 0; --age) {
    const Pair& known = pair(age);
    const double beta = dot(known.gradient_change, displacement) / known.product;
    displacement += (share[static_cast<std::size_t>(age)] - beta) * known.displacement;
  }
}

}  // namespace ribbon

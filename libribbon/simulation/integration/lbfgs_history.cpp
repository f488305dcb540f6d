#include "simulation/integration/lbfgs_history.h"

#include <algorithm>
#include <utility>

#include "simulation/integration/ordered_sums.h"

namespace ribbon {

using Eigen::Index;
using Eigen::MatrixX3d;

// All at once: a later step takes no memory, however soon those before it found their minimum.
LbfgsHistory::LbfgsHistory(Index particles) : rest_(particles, 3) {
  offered_.displacement.resize(particles, 3);
  offered_.gradient_change.resize(particles, 3);
  pairs_.fill(offered_);
}

void LbfgsHistory::add(const Place& from, const Place& to, double least_curvature) {
  const Index particles = from.displacement.rows();
  const auto take_run = [&](Index first, Index count, std::array<double, 2>& sums) {
    const auto run = [&](auto& rows) { return rows.middleRows(first, count); };
    run(offered_.displacement) = run(to.displacement) - run(from.displacement);
    run(offered_.gradient_change) = run(to.gradient) - run(from.gradient);
    sums = {sum_of_products(offered_.displacement, offered_.gradient_change, first, count),
            sum_of_products(offered_.displacement, offered_.displacement, first, count)};
  };
  const auto [product, squared_length] = of_offered_.of(particles, take_run);
  if (!(product > least_curvature * squared_length)) return;
  std::swap(offered_, pairs_[next_]);
  next_ = (next_ + 1) % most_pairs;
  count_ = std::min(count_ + 1, most_pairs);
  Pair& newest = pairs_[(next_ + most_pairs - 1) % most_pairs];
  const auto multiply_run = [&](Index first, Index count, OfPairs& sums) {
    for (int age = 0; age < count_; ++age)
      sums[age] = sum_of_products(pair(age).displacement, newest.gradient_change, first, count);
  };
  newest.products = of_pairs_.of(particles, multiply_run);
}

// The two loops of Nocedal, "Updating quasi-Newton matrices with limited storage", 1980. Products
// of pairs are known, so that each loop passes through memory twice: for all products with what it
// begins with, and for what it ends with.
double LbfgsHistory::toward_minimum(QuasiNewtonMatrix& matrix, const MatrixX3d& gradient,
                                    MatrixX3d& displacement) {
  const Index particles = gradient.rows();
  OfPairs alpha = of_pairs_.of(particles, [&](Index first, Index count, OfPairs& sums) {
    for (int age = 0; age < count_; ++age)
      sums[age] = -sum_of_products(pair(age).displacement, gradient, first, count);
  });
  for (int age = 0; age < count_; ++age) {
    for (int newer = 0; newer < age; ++newer) alpha[age] -= alpha[newer] * product(newer, age);
    alpha[age] /= product(age, age);
  }
  for_each_particle_run(particles, [&](Index first, Index count) {
    auto rest = rest_.middleRows(first, count);
    rest = -gradient.middleRows(first, count);
    for (int age = 0; age < count_; ++age)
      rest -= alpha[age] * pair(age).gradient_change.middleRows(first, count);
  });
  matrix.solve(rest_, displacement);
  OfPairs left = of_pairs_.of(particles, [&](Index first, Index count, OfPairs& sums) {
    for (int age = 0; age < count_; ++age)
      sums[age] = sum_of_products(pair(age).gradient_change, displacement, first, count);
  });
  for (int age = count_ - 1; age >= 0; --age) {
    for (int older = count_ - 1; older > age; --older)
      left[age] += left[older] * product(age, older);
    left[age] = alpha[age] - left[age] / product(age, age);
  }
  return slope_.of(particles, [&](Index first, Index count, std::array<double, 1>& slope) {
    for (int age = 0; age < count_; ++age)
      displacement.middleRows(first, count) +=
          left[age] * pair(age).displacement.middleRows(first, count);
    slope[0] = sum_of_products(gradient, displacement, first, count);
  })[0];
}

}  // namespace ribbon

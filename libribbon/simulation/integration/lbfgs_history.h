// What a quasi-Newton method has learned of the second derivatives so far (L-BFGS).
#pragma once

#include <Eigen/Core>
#include <array>

#include "simulation/integration/quasi_newton_matrix.h"

namespace ribbon {

// The last few displacements, and the changes of the gradient that they brought.
class LbfgsHistory {
 public:
  void clear() { count_ = 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }

  // Adds one displacement, particles x 3, in place of the oldest. Leaves it out where the gradient
  // did not grow along it by at least `least_curvature` per length: such pairs would not lead
  // downhill.
  void add(const Eigen::MatrixX3d& displacement, const Eigen::MatrixX3d& gradient_change,
           double least_curvature);

  // The displacement toward the minimum; the matrix stands for what the history does not know of
  // the second derivatives. Overwrites the negative gradient.
  void toward_minimum(QuasiNewtonMatrix& matrix, Eigen::MatrixX3d& negative_gradient,
                      Eigen::MatrixX3d& displacement) const;

 private:
  static constexpr int most_pairs = 5;

  struct Pair {
    Eigen::MatrixX3d displacement;
    Eigen::MatrixX3d gradient_change;
    double product = 0;
  };

  // 0 is the newest.
  [[nodiscard]] const Pair& pair(int age) const {
    return pairs_[(next_ + most_pairs - 1 - age) % most_pairs];
  }

  std::array<Pair, most_pairs> pairs_;
  int next_ = 0;
  int count_ = 0;
};

}  // namespace ribbon

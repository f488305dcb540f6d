// What a quasi-Newton method has learned of the second derivatives so far (L-BFGS).
#pragma once

#include <Eigen/Core>
#include <array>

#include "simulation/integration/particle_runs.h"
#include "simulation/integration/quasi_newton_matrix.h"

namespace ribbon {

// The last few displacements, and the changes of the gradient that they brought.
class LbfgsHistory {
 public:
  explicit LbfgsHistory(Eigen::Index particles);

  void clear() { count_ = 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }

  // A displacement and the gradient there, both particles x 3.
  struct Place {
    Eigen::MatrixX3d displacement;
    Eigen::MatrixX3d gradient;
  };

  // Adds the way from one place to another, and drops the oldest if there are too many. Leaves it
  // out where the gradient did not grow along it by at least `least_curvature` per length: such
  // pairs would not lead downhill.
  void add(const Place& from, const Place& to, double least_curvature);

  // Overwrites the displacement by the one toward the minimum, and returns the slope along it,
  // gradient times displacement. The matrix stands for what the history does not know of the second
  // derivatives.
  double toward_minimum(QuasiNewtonMatrix& matrix, const Eigen::MatrixX3d& gradient,
                        Eigen::MatrixX3d& displacement);

 private:
  static constexpr int most_pairs = 5;
  using OfPairs = std::array<double, most_pairs>;  // by age

  struct Pair {
    Eigen::MatrixX3d displacement;
    Eigen::MatrixX3d gradient_change;
    OfPairs products{};  // of its gradient change with its displacement and those before it
  };

  // 0 is the newest.
  [[nodiscard]] const Pair& pair(int age) const {
    return pairs_[(next_ + most_pairs - 1 - age) % most_pairs];
  }
  // Of the gradient change of one pair and the displacement of another, as old or older.
  [[nodiscard]] double product(int age, int older) const { return pair(age).products[older - age]; }

  std::array<Pair, most_pairs> pairs_;
  Pair offered_;
  int next_ = 0;
  int count_ = 0;
  Eigen::MatrixX3d rest_;  // of the negative gradient: what the history does not know
  RunSums<most_pairs> of_pairs_;
  RunSums<2> of_offered_;
  RunSums<1> slope_;
};

}  // namespace ribbon

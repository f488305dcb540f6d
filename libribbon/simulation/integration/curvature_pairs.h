// What a quasi-Newton method has learned of the second derivatives on its way (L-BFGS).
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>

namespace ribbon {

// The last few displacements and the changes of the gradient that they brought.
class CurvaturePairs {
 public:
  void clear() { count_ = 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }

  // Learns from one displacement, particles x 3. Forgets it again where the gradient did not grow
  // along it by at least `least_curvature` per length: such pairs would not lead downhill.
  void learn(const Eigen::MatrixX3d& displacement, const Eigen::MatrixX3d& gradient_change,
             double least_curvature);

  // Turns a negative gradient into the displacement toward the minimum. `solve` does so for the
  // second derivatives as known without any pair; it overwrites its second argument.
  using Solve = std::function<void(const Eigen::MatrixX3d&, Eigen::MatrixX3d&)>;
  void toward_minimum(Eigen::MatrixX3d& negative_gradient, const Solve& solve,
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
    return pairs_[static_cast<std::size_t>((next_ + most_pairs - 1 - age) % most_pairs)];
  }

  std::array<Pair, most_pairs> pairs_;
  int next_ = 0;
  int count_ = 0;
};

}  // namespace ribbon

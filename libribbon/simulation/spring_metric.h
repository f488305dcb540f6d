// How much a displacement of the particles costs, at most: their inertia, and all springs as if
// they were stretched along it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ribbon_mesh/springs.h"

namespace ribbon {

// The matrix A = inertia I + sum of resistance (e_a - e_b) (e_a - e_b)^T over the springs, the same
// for each axis and however the ribbon lies. No second derivative of inertia and springs exceeds it
// (Liu, Bargteil, O'Brien and Kavan, "Fast simulation of mass-spring systems", 2013). It is
// factored once; the factor of a ribbon is a narrow band.
class SpringMetric {
 public:
  // inertia: N/m, above 0, what displacing one particle costs by itself.
  SpringMetric(const SpringNetwork& network, int particle_count, double inertia);

  // Overwrites `displacement` with A^-1 force, both particles x 3.
  void solve(const Eigen::MatrixX3d& force, Eigen::MatrixX3d& displacement);

 private:
  // Three axes and a filler, so that a particle fills whole registers.
  using Row = Eigen::Array4d;

  // The factor column by column: what lies below its diagonal, and the diagonal.
  std::vector<std::size_t> begin_;
  std::vector<int> row_;
  std::vector<double> value_;
  std::vector<double> inverse_diagonal_;
  std::vector<int> particle_;  // of each column
  std::vector<Row> solution_;
};

}  // namespace ribbon

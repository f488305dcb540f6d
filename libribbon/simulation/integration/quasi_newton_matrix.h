// How much a displacement of the particles costs, at most: their inertia, and all springs as if
// they were stretched along it.
#pragma once

#include <Eigen/Core>
#include <array>

#include "ribbon_mesh/springs.h"

namespace ribbon {

// The matrix A = inertia + sum of stiffness (e_a - e_b) (e_a - e_b)^T over the springs, the same
// for each axis and however the ribbon lies. No second derivative of inertia and springs exceeds it
// (Liu, Bargteil, O'Brien and Kavan, "Fast simulation of mass-spring systems", 2013).
//
// The ribbon is taken as mirrored in its selvages: only there, and by springs more, never fewer,
// does A differ from that of the network. Then cosines across the ribbon are its modes, each of
// which is solved along the ribbon as a band of five diagonals: no factor fills in, however wide
// the ribbon is.
class QuasiNewtonMatrix {
 public:
  // Of a network whose families reach two rows at most, with each (rows, columns) also its mirror
  // image (rows, -columns). inertia: N/m, above 0, what displacing one particle costs by itself;
  // heaviness: how many times that, above 0, for each row; empty: once.
  QuasiNewtonMatrix(const SpringNetwork& network, double inertia,
                    const Eigen::ArrayXd& heaviness = {});

  // Overwrites `displacement` with A^-1 force, both particles x 3.
  void solve(const Eigen::MatrixX3d& force, Eigen::MatrixX3d& displacement);

 private:
  void factor(const SpringNetwork& network, double inertia, const Eigen::ArrayXd& heaviness);
  void solve_along(Eigen::MatrixXd& amplitudes) const;

  RibbonGrid grid_;
  Eigen::MatrixXd modes_;    // one in each row, orthonormal
  Eigen::MatrixXd columns_;  // one mode in each: its transpose and inverse
  // One column for each row of the ribbon, one row for each mode: A = L D L^T, what of L lies one
  // and two rows before the diagonal, and the inverse of D.
  Eigen::ArrayXXd one_before_;
  Eigen::ArrayXXd two_before_;
  Eigen::ArrayXXd inverse_;
  std::array<Eigen::MatrixXd, 3> amplitudes_;  // of the modes, for each axis
};

}  // namespace ribbon

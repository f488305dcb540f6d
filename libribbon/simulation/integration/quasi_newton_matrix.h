// About how much a displacement of the particles costs: their inertia, and the springs as they lie.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "ribbon_mesh/springs.h"
#include "simulation/integration/block_band.h"
#include "simulation/integration/cosine_modes.h"
#include "simulation/integration/fours.h"
#include "simulation/integration/holding.h"
#include "simulation/integration/middle.h"

namespace ribbon {

// The matrix A = inertia + sum of stiffness (e_a - e_b) P (e_a - e_b)^T over the springs, where P =
// n n^T + 0.05 (1 - n n^T) of a spring of direction n. At its rest length a spring resists along it
// alone; the rest stands for what it resists when it is stretched, or has turned since.
//
// The springs of a family that lead from one row count alike, with the mean of their P, and those
// of two families that cross with that of both. The ribbon is taken as mirrored in its selvages,
// which adds springs there. So cosines across the ribbon are its modes, each of which is solved
// along the ribbon as a band of five diagonals: no factor fills in, however wide the ribbon is.
//
// Where hands hold particles, each by itself, their springs add to the inertia of rows; where they
// hold the middle of several, these are coupled by a matrix of rank three (Sherman and Morrison).
class QuasiNewtonMatrix {
 public:
  // Of a network whose families reach two rows at most, with each (rows, columns) also its mirror
  // image (rows, -columns). inertia: N/m, above 0, what displacing one particle costs by itself;
  // heaviness: how many times that, above 0, for each row; empty: once.
  QuasiNewtonMatrix(const SpringNetwork& network, double inertia,
                    const Eigen::ArrayXd& heaviness = {});

  // From the next factor() on.
  void set_inertia(double inertia);

  // Of the springs as they lie between particles (particles x 3) that are there, and of what draws
  // them elsewhere; what that refers to must outlive solve(). Single particles are drawn by rows.
  void factor(const Eigen::MatrixX3d& positions, std::span<const SharedSpring> held = {});

  // Overwrites `displacement` with A^-1 force, both particles x 3. After factor().
  void solve(const Eigen::MatrixX3d& force, Eigen::MatrixX3d& displacement);

 private:
  // A family and, if it has another, its mirror image, which costs each mode as much.
  struct Springs {
    std::vector<SpringFamily> families;       // without rest lengths
    double stiffness = 0;                     // N/m
    std::vector<Fours<1>> cost;               // of each four of modes
    std::vector<Eigen::Matrix3d> resistance;  // of each row, all of it: stiffness times P, N/m
  };

  // One axis of a spring that draws several particles.
  struct Coupling {
    Middle middle;
    int axis = 0;
    Eigen::MatrixX3d answer;  // of the matrix without it, to a force by shares
    double yielding = 0;      // m/N, of the middle and the spring after one another
  };

  void couple(const SharedSpring& spring);
  void look_along(int row, const Eigen::MatrixX3d& positions, Springs& springs) const;
  void assemble(int four);

  RibbonGrid grid_;
  CosineModes modes_;
  Eigen::ArrayXd heaviness_;  // of each row
  double least_inertia_ = 0;  // beside the springs
  Eigen::ArrayXd inertia_;    // of each row
  Eigen::ArrayXd held_;       // N/m, in each row, of a particle
  std::vector<Springs> springs_;
  std::vector<Coupling> couplings_;
  std::size_t coupled_ = 0;  // so many of these count
  Eigen::MatrixX3d by_shares_;
  // Of each four of modes:
  std::vector<BlockBand> bands_;
  std::vector<std::vector<FourVectors>> amplitudes_;
};

}  // namespace ribbon

// The internal friction of the cloth, by which a ribbon comes to rest. The paper has none.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "ribbon_mesh/springs.h"

namespace ribbon {

// One dashpot for each particle (i, j) of a grid, between the particles (i + rows, j + columns) of
// all its ends, where these exist.
struct DashpotFamily {
  struct End {
    int rows = 0;
    int columns = 0;
  };

  // ends: two to four, from the first row on, rows and columns >= 0.
  explicit DashpotFamily(std::vector<End> ends);

  // Of the ends of each dashpot, by how many there are: they tell the one point from the other.
  template <std::size_t ends>
  static constexpr std::array<double, ends> weights() {
    static_assert(ends >= 2 && ends <= 4);
    if constexpr (ends == 2) return {-1, 1};
    if constexpr (ends == 3) return {0.5, -1, 0.5};
    if constexpr (ends == 4) return {0.5, -0.5, -0.5, 0.5};
  }

  std::vector<End> ends;
  int rows = 0;  // that it reaches
  int columns = 0;
  double squared_weights = 0;  // of the ends: their sum
  // Have those at neighbouring particles of a row no particle in common?
  bool are_apart_in_a_row = false;
  double rate_per_s = 0;  // at which it slows
};

// Dashpots slow the speed at which two points of the cloth part or approach, along the line between
// them:
// - beside each spring, its two particles;
// - where bending resists, each particle and the middle of its two neighbours along, and across: a
//   fold that opens hardly changes the length of springs;
// - there, too, the middles of both diagonals of each quad, which part when it twists.
// Points are sums of particles with weights w, and a spring of stiffness k between two of them
// swings at sqrt(sum(w^2) k / mass). With r = 2 damping h times that, the speed becomes
// (1 - r / 2) / (1 + r / 2) of what it was (the midpoint rule for that dashpot alone), nothing from
// r = 2 on, one dashpot after the other (Shardlow, "Splitting for dissipative particle dynamics",
// 2003). Stable for any springs and any h; momentum and angular momentum stay, kinetic energy never
// grows. What moves smoothly over the network loses the same in a second for any h: there each
// dashpot meets what its neighbour has just added, by which the speed is 1 + r / 2 times as high.
//
// Where rows weigh differently, dashpots that lead from row to row heed it. Those that have two
// particles in a row only exchange speed within rows, whose particles weigh the same; they slow it
// as in a row of mean mass.
class InternalDamping {
 public:
  // network.damping: > 0; particle_mass_kg: mean; lightness: as Cloth has it.
  InternalDamping(const SpringNetwork& network, double particle_mass_kg,
                  const Eigen::ArrayXd& lightness = {});

  // What it does to the velocities in h seconds. particles x 3 each, m and m/s. In an order that
  // depends on the grid alone.
  void apply(double h, const Eigen::MatrixX3d& positions, Eigen::MatrixX3d& velocities);

 private:
  // The particles of some rows, in another layout.
  struct Lot {
    Eigen::MatrixX3d positions;
    Eigen::MatrixX3d velocities;
  };

  // For InternalDamping's tasks: null where rows count as equally heavy.
  [[nodiscard]] const double* lightness_for(const DashpotFamily& family) const;
  // All dashpots between the rows of a lot.
  void damp_lot(double h, int lot, const Eigen::MatrixX3d& positions, Eigen::MatrixX3d& velocities);
  // Those that lead from the rows of a lot to the next.
  void damp_after_lot(double h, int lot, const Eigen::MatrixX3d& positions,
                      Eigen::MatrixX3d& velocities);

  RibbonGrid grid_;
  std::vector<double> lightness_;  // of the rows; empty: all weigh the same
  std::vector<DashpotFamily> families_;
  std::vector<Lot> lots_;
};

}  // namespace ribbon

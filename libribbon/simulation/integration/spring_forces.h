// The resistance of the springs (paper, section 5.1).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ribbon_mesh/springs.h"

namespace ribbon {

// The forces and the energy of a network, over flat arrays: the springs of a family are computed
// one after the other, without looking up their ends. The results are the same bits for any number
// of threads, compiler and optimisation.
class SpringForces {
 public:
  explicit SpringForces(const SpringNetwork& network);

  // Overwrites `forces` (particles x 3, N) with the force of all springs on each particle:
  // stiffness times elongation, along the spring. A spring without length has no direction and
  // exerts none. positions: particles x 3, m.
  void forces(const Eigen::MatrixX3d& positions, Eigen::MatrixX3d& forces);

  // Likewise. Returns the elastic energy, J: half of each stiffness times elongation squared.
  double forces_and_energy(const Eigen::MatrixX3d& positions, Eigen::MatrixX3d& forces);

  // From now on they resist with that fraction (above 0) of their stiffness.
  void slacken(double fraction) { fraction_ = fraction; }

  [[nodiscard]] bool empty() const { return families_.empty(); }

 private:
  // Spring i of a family leads from particle i to particle i + offset. Where that would reach over
  // a selvage, into the next row, there is none: its stiffness is 0.
  struct Family {
    Eigen::Index offset = 0;
    double rest_length_m = 0;
    std::vector<double> rest_lengths_m;  // as in SpringFamily
    Eigen::ArrayXd stiffness;            // N/m
  };

  // What the springs at one range of particles need while they are computed.
  struct Workspace {
    Eigen::MatrixX3d tension;        // N, of each spring on the particle where it starts
    Eigen::VectorXd twice_energy_j;  // of each spring, once energy was asked for
    double energy_j = 0;             // of the springs that start in the range
  };

  void add(const SpringFamily& family, double stiffness, const RibbonGrid& grid);
  // Of all particles and of a range; with_energy: and the energy into the workspaces.
  void compute(bool with_energy, const Eigen::MatrixX3d& positions, Eigen::MatrixX3d& forces);
  void forces_on(Eigen::Index begin, Eigen::Index end, bool with_energy,
                 const Eigen::MatrixX3d& positions, Eigen::MatrixX3d& forces);

  Eigen::Index particle_count_;
  std::vector<Family> families_;
  Eigen::Index grain_ = 0;  // particles in a range
  double fraction_ = 1;     // of their stiffness
  std::vector<Workspace> workspaces_;
};

// An upper bound of the fastest angular frequency (rad/s) at which any particle can swing on its
// springs, however the ribbon lies. particle_mass_kg: mean; lightness: as Cloth has it.
double fastest_frequency(const SpringNetwork& network, double particle_mass_kg,
                         const Eigen::ArrayXd& lightness = {});

}  // namespace ribbon

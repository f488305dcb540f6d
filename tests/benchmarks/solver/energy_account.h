// What happens to the energy of a ribbon, told by its positions alone.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "ribbon_mesh/ribbon_mesh.h"
#include "ribbon_mesh/springs.h"
#include "scene/scene.h"
#include "simulation/fastening/fastening_force.h"

namespace ribbon {

// What the springs hold and what moves, against what there was at the start and what the fastening
// force and gravity have put in.
class EnergyAccount {
 public:
  // start: 3 x particles.
  EnergyAccount(const Scene& scene, const RibbonMesh& mesh, const Eigen::Matrix3Xd& start);

  // Hands that yield put in less than is counted here.
  void add_step(const Eigen::Matrix3Xd& before, const Eigen::Matrix3Xd& after);

  // Energy over what had been put in, when that was most. Above 1, contact and strain correction
  // have strained springs.
  [[nodiscard]] double most() const { return most_; }

  // Was there ever more than what had been put in and what all springs hold at the strain limit of
  // 10 %? Then no bound is in sight.
  [[nodiscard]] bool is_explosion() const { return is_explosion_; }

 private:
  [[nodiscard]] double at_strain_limit_j() const;

  SpringNetwork network_;
  double step_s_;
  double mass_kg_;  // of a particle
  double put_in_j_;
  Eigen::Vector3d gravity_m_s2_;
  double most_ = 0;
  bool is_explosion_ = false;
  std::optional<FasteningForce> force_;
};

}  // namespace ribbon

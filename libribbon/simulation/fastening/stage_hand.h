// One hand that has a part of the band in one stage.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/rest_size.h"
#include "scene/scene.h"
#include "simulation/fastening/carried_place.h"
#include "simulation/fastening/held_rows.h"
#include "simulation/fastening/yielding.h"
#include "simulation/state/cloth.h"

namespace ribbon {

// What a hand is to know beside the cloth.
struct Workplace {
  const Eigen::Matrix3Xd& begun;  // 3 x particles, where they were when the stage began
  const Eigen::Matrix3Xd& along;  // 3 x particles, m/s: FasteningForce as a velocity; no columns
                                  // where no hand pulls along
  double bearable = 1;            // the fraction of its force that the cloth can bear
};

class StageHand {
 public:
  // Its span and its path are known: marks have been found in the drawing. begun: 3 x particles,
  // where they were when the stage began.
  StageHand(const HandScene& hand, const Scene& scene, const RestSize& size,
            double particle_mass_kg, const Eigen::Matrix3Xd& begun);

  [[nodiscard]] const HeldRows& rows() const { return rows_; }
  [[nodiscard]] bool pulls() const { return ribbon::pulls(*hand_.task); }
  // Is what it carries, if anything, where it is to be?
  [[nodiscard]] bool has_arrived() const { return !carried_ || carried_->has_arrived(); }

  // Writes, for the particles that it has, the force of the next step (3 x particles, N) and, where
  // it pulls, the velocity that all of its bearable force would reach against the air (m/s). Gives
  // the fraction of its force that it applies.
  double pull(const Cloth& cloth, const Workplace& place, Eigen::Matrix3Xd& force,
              Eigen::Matrix3Xd& command);

  // After the step. The place to which it carries waits while all of its force is needed: what
  // lags behind is drawn along the path, and not across.
  void follow(const Cloth& cloth);

  void visit_state(StateArchive& archive);

 private:
  [[nodiscard]] Eigen::Vector3d direction(const Cloth& cloth) const;
  [[nodiscard]] Eigen::Vector3d middle(const Eigen::Matrix3Xd& of_particles) const;
  [[nodiscard]] double most_force_n() const;
  [[nodiscard]] Eigen::Vector3d wanted_force(const Eigen::Vector3d& off_m,
                                             const Eigen::Vector3d& velocity_m_s) const;
  [[nodiscard]] Eigen::Vector3d carrying_force(const Cloth& cloth) const;
  void hold(const Cloth& cloth, const Workplace& place, Eigen::Matrix3Xd& force) const;

  HandScene hand_;
  FasteningScene fastening_;
  RibbonGrid grid_;
  HeldRows rows_;
  double newton_per_m_s_;  // of particles that are pulled along: their force for each m/s
  double draws_;           // so many particles each of those that the hand has draws
  double hold_per_s_;      // how fast a held particle goes back to its place
  double air_per_s_;
  double step_s_;
  double particle_mass_kg_;
  std::optional<Yielding> yielding_;
  std::optional<CarriedPlace> carried_;
};

}  // namespace ribbon

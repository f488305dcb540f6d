// One hand that has a part of the band in one stage.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/rest_size.h"
#include "scene/held_rows.h"
#include "scene/scene.h"
#include "simulation/fastening/carried_place.h"
#include "simulation/fastening/yielding.h"
#include "simulation/state/cloth.h"
#include "simulation/state/grip.h"

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
  // rows: those that it has, at least one. Its path is known: it has been found in the drawing.
  // begun: 3 x particles, where they were when the stage began.
  StageHand(const HandScene& hand, const HeldRows& rows, const Scene& scene, const RestSize& size,
            double particle_mass_kg, const Eigen::Matrix3Xd& begun);

  [[nodiscard]] const HeldRows& rows() const { return rows_; }
  [[nodiscard]] bool pulls() const { return ribbon::pulls(*hand_.task); }
  [[nodiscard]] bool carries() const { return carried_.has_value(); }
  // Is what it carries, if anything, where it is to be, and nearly at rest?
  [[nodiscard]] bool has_arrived() const { return !carried_ || has_arrived_; }

  // Of one that pulls: writes, for the particles that it has, the force of the next step (3 x
  // particles, N) and the velocity that all of its bearable force would reach against the air
  // (m/s). Gives the fraction of its force that it applies.
  double pull(const Cloth& cloth, const Workplace& place, Eigen::Matrix3Xd& force,
              Eigen::Matrix3Xd& command);

  // Of one that holds or carries, in the next step. The place to which it carries waits while its
  // part lags behind by more than it can make up for on the way: what lags is drawn along the path,
  // and not across. Refers to `place`.
  Grip grip(const Cloth& cloth, const Workplace& place);

  // After the step.
  void follow(const Cloth& cloth);

  // Of one that carries.
  void visit_state(StateArchive& archive);

 private:
  [[nodiscard]] Eigen::Vector3d direction(const Cloth& cloth) const;
  [[nodiscard]] Eigen::Vector3d middle(const Eigen::Matrix3Xd& of_particles) const;
  [[nodiscard]] double carrying_m_s() const;
  [[nodiscard]] double strength_m_s2() const;

  HandScene hand_;
  FasteningScene fastening_;
  RibbonGrid grid_;
  HeldRows rows_;
  double newton_per_m_s_;   // of particles that are pulled along: their force for each m/s
  double draws_;            // so many particles each of those that the hand has draws
  Eigen::ArrayXd weights_;  // of its particles, as Grip has them
  double air_per_s_;
  double step_s_;
  double arrived_m_;  // from the end of the path: near enough
  std::optional<Yielding> yielding_;
  std::optional<CarriedPlace> carried_;
  Eigen::Vector3d carried_to_ = Eigen::Vector3d::Zero();  // m, as the present step begins
  double goes_on_m_ = 0;                                  // so far does it carry in that
  bool has_arrived_ = false;
};

}  // namespace ribbon

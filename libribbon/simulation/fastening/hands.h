// What fastens a ribbon (paper, section 3.3: two invisible hands).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "ribbon_mesh/rest_size.h"
#include "scene/scene.h"
#include "simulation/fastening/fastening_force.h"
#include "simulation/fastening/fastening_progress.h"
#include "simulation/fastening/speed_limit.h"
#include "simulation/fastening/yielding.h"
#include "simulation/state/cloth.h"
#include "simulation/state/state_archive.h"

namespace ribbon {

// They pull with the fastening force, or with a fraction of it where they yield, feel how the
// ribbon resists, and know when it is tight. What the scene does not name, yield and max_speed, is
// neither held nor computed.
class Hands {
 public:
  // The scene has a fastening; cloth is the ribbon at its start.
  Hands(const Scene& scene, const RestSize& size, const Cloth& cloth);

  // The force for the next step, 3 x particles, N.
  const Eigen::Matrix3Xd& pull(const Cloth& cloth);

  // The cloth cannot bear what they pulled: they halve it. From then on they pull a little more in
  // every step.
  void ease();

  // After the step: how far did the ribbon follow?
  void follow(const Cloth& cloth);

  // The fraction of the fastening force that they applied last.
  [[nodiscard]] double force_fraction() const { return force_fraction_; }

  // FasteningProgress::recent().
  [[nodiscard]] double progress() const { return progress_.recent(); }

  // Over the last two seconds the ribbon went less than 3 % of the distance that the force would
  // take it without springs and contact.
  [[nodiscard]] bool are_stopped() const;

  // All but what they remember of the last two seconds, which is of use only to hands that go on
  // pulling in the same way.
  void visit_state(StateArchive& archive);
  void visit_memory(StateArchive& archive) { progress_.visit_memory(archive); }

 private:
  FasteningForce force_;
  std::optional<Yielding> yielding_;
  std::optional<SpeedLimit> speed_limit_;
  FasteningProgress progress_;
  double highest_m_s_;
  double bearable_ = 1;  // the fraction of the force that the cloth can bear, as far as is known
  double force_fraction_ = 1;
  Eigen::Matrix3Xd pull_;     // N, of the present step
  Eigen::Matrix3Xd command_;  // m/s, of the present step, by what the cloth can bear
  Eigen::Matrix3Xd before_;   // positions, of the present step
};

}  // namespace ribbon

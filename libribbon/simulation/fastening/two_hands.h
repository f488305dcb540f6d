// What fastens a ribbon that is pulled as a whole (paper, section 3.3: two invisible hands).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/rest_size.h"
#include "scene/scene.h"
#include "simulation/fastening/eased_force.h"
#include "simulation/fastening/fastening_force.h"
#include "simulation/fastening/fastening_progress.h"
#include "simulation/fastening/hands.h"
#include "simulation/fastening/speed_limit.h"
#include "simulation/fastening/yielding.h"

namespace ribbon {

// They pull with the fastening force, or with a fraction of it where they yield, feel how the
// ribbon resists, and know when it is tight. Where the scene has yield = "never" or no max_speed,
// nothing of it is held or computed.
class TwoHands : public Hands {
 public:
  // The scene has a fastening; cloth is the ribbon at its start.
  TwoHands(const Scene& scene, const RestSize& size, const Cloth& cloth);

  const Eigen::Matrix3Xd& pull(const Cloth& cloth) override;
  void ease() override { eased_.ease(); }
  void follow(const Cloth& cloth) override;
  [[nodiscard]] double force_fraction() const override { return force_fraction_; }
  [[nodiscard]] double progress() const override { return progress_.recent(); }
  // Over the last two seconds the ribbon went less than 3 % of the distance that the force would
  // take it without springs and contact.
  [[nodiscard]] bool are_done() const override { return progress_.is_at_standstill(); }

  void visit_state(StateArchive& archive) override;
  void visit_memory(StateArchive& archive) override { progress_.visit_memory(archive); }

 private:
  FasteningForce force_;
  std::optional<Yielding> yielding_;
  std::optional<SpeedLimit> speed_limit_;
  FasteningProgress progress_;
  double highest_m_s_;
  EasedForce eased_;
  double force_fraction_ = 1;
  Eigen::Matrix3Xd pull_;     // N, of the present step
  Eigen::Matrix3Xd command_;  // m/s, of the present step, by what the cloth can bear
  Eigen::Matrix3Xd before_;   // positions, of the present step
};

}  // namespace ribbon

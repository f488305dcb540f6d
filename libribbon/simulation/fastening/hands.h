// What fastens a ribbon (paper, section 3.3: two invisible hands).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/ribbon_grid.h"
#include "scene/scene.h"
#include "simulation/fastening/fastening_force.h"
#include "simulation/fastening/fastening_progress.h"
#include "simulation/fastening/speed_limit.h"
#include "simulation/fastening/yielding.h"
#include "simulation/state/cloth.h"
#include "simulation/state/state_archive.h"

namespace ribbon {

// Pull, feel how the ribbon resists, and know when it is tight. What the scene does not name, yield
// and max_speed, is neither held nor computed.
class Hands {
 public:
  // The scene has a fastening; cloth is the ribbon at its start.
  Hands(const Scene& scene, const RibbonGrid& grid, double length_m, const Cloth& cloth);

  // The force for the next step, 3 x particles, N.
  Eigen::Matrix3Xd pull(const Cloth& cloth);

  // After the step.
  void follow(const Cloth& cloth);

  // The share of the fastening force that they applied last; 1 where they do not yield.
  [[nodiscard]] double share() const { return share_; }

  // FasteningProgress::recent().
  [[nodiscard]] double progress() const { return progress_.recent(); }

  // Over the last two seconds the ribbon went less than 3 % of the way that it was told to go.
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
  double share_ = 1;
  Eigen::Matrix3Xd command_;  // m/s, of the present step
  Eigen::Matrix3Xd before_;   // positions, of the present step
};

}  // namespace ribbon

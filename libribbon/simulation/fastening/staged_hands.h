// Hands that fasten a ribbon in stages (paper, section 7: knots fastened one by one).
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/rest_size.h"
#include "scene/scene.h"
#include "simulation/fastening/eased_force.h"
#include "simulation/fastening/fastening_force.h"
#include "simulation/fastening/fastening_progress.h"
#include "simulation/fastening/hands.h"
#include "simulation/fastening/slip_guard.h"
#include "simulation/fastening/speed_limit.h"
#include "simulation/fastening/stage_hand.h"

namespace ribbon {

// In each stage other hands have parts of the band, and pull, hold or carry them. A stage is over
// when its time is, or when each part that is pulled has come to a stop and each that is carried
// has arrived; the next one then begins with the next step. After the last stage, and once an end
// is about to slip out of its knot, nobody pulls.
class StagedHands : public Hands {
 public:
  // The scene has stages, whose spans are known; cloth is the ribbon at its start.
  StagedHands(const Scene& scene, const RestSize& size, const Cloth& cloth);

  // Before each step: the next stage, if the present one is over.
  void begin_step(const Cloth& cloth);

  const Eigen::Matrix3Xd& pull(const Cloth& cloth) override;
  [[nodiscard]] std::span<const Grip> grips() const override { return grips_; }
  void ease() override { eased_.ease(); }
  void follow(const Cloth& cloth) override;
  // Of the hands that pull, their mean.
  [[nodiscard]] double force_fraction() const override { return force_fraction_; }
  // Of the present stage.
  [[nodiscard]] double progress() const override { return progress_.recent(); }
  // Is the last stage over because the ribbon was tight?
  [[nodiscard]] bool are_done() const override;

  // From 0; the last one also when it is over.
  [[nodiscard]] int stage() const { return stage_; }
  // While the present stage lasts.
  [[nodiscard]] double friction() const;
  [[nodiscard]] std::optional<Eigen::Vector3d> gravity_m_s2() const;
  // Are all stages over?
  [[nodiscard]] bool are_over() const;
  // Of each stage: was it over before it had reached its goal?
  [[nodiscard]] const std::vector<bool>& given_up() const { return given_up_; }
  // The present stage, if it is over, begins once more.
  void begin_anew(const Cloth& cloth);
  [[nodiscard]] SlipGuard& guard() { return guard_; }
  // Does a hand hold or carry the first end, and the second?
  [[nodiscard]] std::array<bool, 2> have_ends() const;
  // Does the guard have to look after this step?
  [[nodiscard]] bool guard_is_due() const;

  void visit_state(StateArchive& archive) override;
  void visit_memory(StateArchive& archive) override;

 private:
  [[nodiscard]] const StageScene& present() const { return scene_.stages[stage_]; }
  [[nodiscard]] bool is_over() const;
  [[nodiscard]] bool goal_is_reached() const;
  void begin_stage(const Cloth& cloth);
  void note_end();
  void take_places();
  void visit_carrying(StateArchive& archive);

  Scene scene_;
  RestSize size_;
  double particle_mass_kg_;
  FasteningForce along_;
  std::optional<SpeedLimit> speed_limit_;
  int stage_ = 0;
  bool is_reached_ = false;       // its goal
  std::vector<bool> given_up_;    // each stage
  double elapsed_s_ = 0;          // of the present stage
  Eigen::Matrix3Xd begun_;        // positions, when it began
  std::vector<StageHand> hands_;  // of it
  FasteningProgress progress_;    // in it
  SlipGuard guard_;
  EasedForce eased_;
  double force_fraction_ = 1;
  Eigen::Matrix3Xd along_m_s_;  // of the present step, no columns where nobody pulls along
  Eigen::Matrix3Xd force_;      // N, of the present step
  Eigen::Matrix3Xd command_;    // m/s, of the present step
  std::vector<Grip> grips_;     // of the present step, of those hands that do not pull
  Eigen::Matrix3Xd before_;     // positions, of the present step
};

}  // namespace ribbon

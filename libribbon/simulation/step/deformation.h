// How a band of one natural size deforms in one step (paper, section 5, Figure 5).
#pragma once

#include <Eigen/Core>
#include <memory>

#include "ribbon_mesh/rest_size.h"
#include "scene/scene.h"
#include "simulation/detection/bodies.h"
#include "simulation/integration/integrator.h"
#include "simulation/state/cloth.h"
#include "simulation/step/post_step.h"
#include "simulation/step/stage_clock.h"

namespace ribbon {

// At most, of settling before the first step.
inline constexpr int settling_rounds = 50;

class Deformation {
 public:
  // Springs, air and contact as the scene wants them. `bodies` must outlive the deformation.
  Deformation(const Scene& scene, const RestSize& size, double particle_mass_kg, Bodies& bodies);

  // Figure 5 from the displacement on. fastening_force: 3 x particles, N, or no columns for none.
  PostStepReport step(const Eigen::Matrix3Xd& fastening_force, Cloth& cloth);

  // Brings the cloth from its positions toward `wished` (3 x vertices), as far as the post-step
  // lets, and leaves it at rest.
  void move(const Eigen::Matrix3Xd& wished, Cloth& cloth);

  // Applies the post-step up to `rounds` times, until no edge is over the strain limit, and leaves
  // the cloth at rest. The report's recovery iterations are those of all rounds.
  PostStepReport settle(int rounds, Cloth& cloth);

  // Into how many parts the springs divide a step.
  [[nodiscard]] int substeps() const { return integrator_->substeps(); }
  // Charged with the steps' stages.
  [[nodiscard]] StageClock& clock() { return *clock_; }
  [[nodiscard]] const StageClock& clock() const { return *clock_; }

 private:
  std::unique_ptr<StageClock> clock_ = std::make_unique<StageClock>();  // at a fixed place
  std::unique_ptr<Integrator> integrator_;
  std::unique_ptr<PostStep> post_step_;
};

}  // namespace ribbon

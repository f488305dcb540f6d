#include <vector>

#include "simulation/contact/collision_response.h"
#include "simulation/detection/swept_pairs.h"
#include "simulation/published/recovery.h"
#include "simulation/published/strain_correction.h"
#include "simulation/step/post_step.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double published_strain_limit = 0.1;  // of the rest length (section 5.5)
constexpr int most_corrections = 10;            // at most, in one step (section 5.5)
constexpr int most_repulsions = 10;             // of detection and repulsion, at most

class PublishedPostStep : public PostStep {
 public:
  PublishedPostStep(Bodies& bodies, const PostStepProperties& properties, StageClock& clock)
      : bodies_(bodies),
        clock_(clock),
        step_s_(properties.step_s),
        gaps_(properties.size, {.contact_m = 0.1 * properties.size.shortest_edge_m(),
                                .thickness_m = properties.thickness_m}),
        repulsion_settings_{.friction = properties.friction},
        strain_correction_(properties.size, published_strain_limit),
        recovery_settings_{.gap_m = 0.1 * properties.size.shortest_edge_m(),
                           .step_m = 0.5 * properties.size.shortest_edge_m()} {}

  PostStepReport correct(const Matrix3Xd& before, Cloth& cloth) override {
    repel(before, cloth);
    clock_.charge(Stage::smoothing);
    smooth(cloth);
    clock_.charge(Stage::errors);
    const RecoveryReport recovery = recover(bodies_, recovery_settings_, cloth.positions);
    return {.recovery_iterations = recovery.iterations,
            .penetrating_edges = recovery.penetrating_edges,
            .is_over_limit = strain_correction_.any_over_limit(cloth.positions)};
  }

 private:
  // while ∃ collision: update velocity, displacement.
  void repel(const Matrix3Xd& before, Cloth& cloth) {
    for (int round = 0; round < most_repulsions; ++round) {
      clock_.charge(Stage::detection);
      const std::vector<FeaturePair> pairs =
          swept_pairs_by_curvature(bodies_, before, cloth.positions, gaps_.largest_contact_m());
      clock_.count_detection(pairs.size());
      clock_.charge(Stage::repulsion);
      if (!repel_once(pairs, gaps_, repulsion_settings_, before, cloth)) return;
    }
  }

  // while ∃ over-stretched edge: apply post-step correction. What moves the particles also changes
  // their velocities, so that the springs are not stretched again in the next step.
  void smooth(Cloth& cloth) const {
    const Matrix3Xd before = cloth.positions;
    int rounds = 0;
    while (rounds < most_corrections && strain_correction_.any_over_limit(cloth.positions)) {
      strain_correction_.apply(cloth.positions);
      ++rounds;
    }
    clock_.count_sweeps(rounds);
    if (rounds > 0)
      cloth.velocities += (cloth.positions - before).leftCols(cloth.particle_count()) / step_s_;
  }

  Bodies& bodies_;
  StageClock& clock_;
  double step_s_;
  PairGaps gaps_;
  RepulsionSettings repulsion_settings_;
  StrainCorrection strain_correction_;
  RecoverySettings recovery_settings_;
};

}  // namespace

std::unique_ptr<PostStep> published_post_step(Bodies& bodies, const PostStepProperties& properties,
                                              StageClock& clock) {
  return std::make_unique<PublishedPostStep>(bodies, properties, clock);
}

}  // namespace ribbon

// The time step as published (paper, section 5, Figure 5): contact = "paper".
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "geometry/rest_size.h"
#include "scene/scene.h"
#include "simulation/contact/pair_distances.h"
#include "simulation/detection/bodies.h"
#include "simulation/detection/feature_pairs.h"
#include "simulation/fastening/hands.h"
#include "simulation/published/recovery.h"
#include "simulation/published/strain_correction.h"
#include "simulation/state/cloth.h"
#include "simulation/step/step_report.h"
#include "simulation/step/time_step.h"

namespace ribbon {

// The strain correction may push the ribbon through itself, and schemes A, B and C bring it back as
// well as they can.
class PublishedStep : public TimeStep {
 public:
  // particle_mass_kg: mean.
  PublishedStep(const Scene& scene, const RestSize& size, double particle_mass_kg);

  StepReport correct(const Eigen::Matrix3Xd& before, Bodies& bodies, Cloth& cloth) override;

  [[nodiscard]] double guaranteed_strain() const override { return 0; }
  [[nodiscard]] double held_strain() const override {
    return std::numeric_limits<double>::infinity();
  }

 private:
  StepReport advance(Hands* hands, Bodies& bodies, Cloth& cloth) override;

  void integrate(const Eigen::Matrix3Xd& force, Cloth& cloth);
  std::vector<FeaturePair> detect(const Eigen::Matrix3Xd& before, Bodies& bodies,
                                  const Cloth& cloth);
  bool repel(const std::vector<FeaturePair>& pairs, const Eigen::Matrix3Xd& before,
             const Bodies& bodies, Cloth& cloth);
  void correct_strain(Cloth& cloth);
  StepReport recover(Bodies& bodies, Cloth& cloth);

  PairDistances distances_;
  PublishedStrainCorrection strain_correction_;
  RecoverySettings recovery_;
};

}  // namespace ribbon

// What explicit integrators have in common: a step is divided until it is stable.
#pragma once

#include <Eigen/Core>

#include "simulation/integration/flat_state.h"
#include "simulation/integration/integrator.h"
#include "simulation/integration/spring_force.h"

namespace ribbon {

class DividedStep : public Integrator {
 public:
  // fastest_rad_s: what may swing or decay fastest; stability_limit: the largest part of a step,
  // times that, at which the scheme is stable.
  DividedStep(const SpringNetwork& springs, const MotionProperties& properties,
              double fastest_rad_s, double stability_limit);

  void displace(const Eigen::Matrix3Xd& fastening_force, Cloth& cloth) final;
  [[nodiscard]] int substeps() const final { return substeps_; }

 protected:
  // One part of the step, of h seconds.
  virtual void advance(double h) = 0;

  SpringForces springs_;
  MotionProperties properties_;
  FlatState state_;

 private:
  int substeps_;
};

}  // namespace ribbon

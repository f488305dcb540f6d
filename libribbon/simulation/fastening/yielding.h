// How hands feel that a ribbon resists (paper, section 3.3: fastening is a subtle feedback
// process).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ribbon_mesh/springs.h"
#include "scene/held_rows.h"
#include "simulation/fastening/hanging_weight.h"

namespace ribbon {

// The more the ribbon is stretched, the less of the fastening force is applied: in proportion, so
// that a ribbon that is locked comes to rest where force and resistance agree.
class Yielding {
 public:
  // What is felt is tension: the mean strain of the edges from one row to the next, as one in a
  // hundred of the rows exceeds it, in which what is only bent to the side does not count. Up to
  // half of `strain` (> 0) it is met with all of the force, at one and a half of it with none.
  // `hanging`: of what gravity pulls; hands do not feel the part of a row's strain that is due to
  // what hangs from it.
  // `felt`: the rows between which the strain is felt; nothing: all.
  Yielding(const RestSize& size, double strain, std::optional<HangingWeight> hanging = std::nullopt,
           std::optional<HeldRows> felt = std::nullopt);

  // The fraction of the force to be applied, 0 to 1. positions: 3 x particles.
  double force_fraction(const Eigen::Matrix3Xd& positions);

 private:
  RibbonGrid grid_;
  SpringFamily along_;
  double strain_;
  HeldRows felt_;
  std::optional<HangingWeight> hanging_;
  std::vector<double> row_rests_m_;  // mean of the edges along from each row; empty: all alike
  std::vector<double> lengths_;      // m, likewise, as if at rest all were along_.rest_length_m
};

}  // namespace ribbon

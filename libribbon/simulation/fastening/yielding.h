// How hands feel that a ribbon resists (paper, section 3.3: fastening is a subtle feedback
// process).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// The share of the fastening force that is applied: the more the ribbon is stretched, the less. In
// proportion, so that a ribbon that is locked comes to rest where force and resistance agree.
class Yielding {
 public:
  // What is felt is the stretch that one in a hundred of the edges along the ribbon exceeds, each
  // length_m / (rows - 1) at rest. Up to half of `strain` (> 0) it is met with all of the force, at
  // one and a half of it with none.
  Yielding(const RibbonGrid& grid, double length_m, double strain);

  // The share of the force for a ribbon that lies as it does now (3 x at least all particles).
  double feel(const Eigen::Matrix3Xd& positions);

 private:
  RibbonGrid grid_;
  double rest_m_;
  double strain_;
  std::vector<double> squared_lengths_;  // m2, of the edges along
};

}  // namespace ribbon

// How hands feel that a ribbon resists (paper, section 3.3: fastening is a subtle feedback
// process).
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// The share of the fastening force that is applied. It falls step by step while the ribbon is
// stretched beyond what the hands put up with, and rises again, up to all of it, when it is not.
class Yielding {
 public:
  // The hands yield when more than one in a hundred edges along the ribbon, each length_m / (rows -
  // 1) at rest, are longer than that by more than `strain` (> 0).
  Yielding(const RibbonGrid& grid, double length_m, double strain);

  // Feels the ribbon as it lies now (3 x at least all particles); returns the share for the next
  // step, 0 ... 1. Equal calls in equal order give equal answers.
  double feel(const Eigen::Matrix3Xd& positions);

 private:
  RibbonGrid grid_;
  double longest_m_;
  double share_ = 1;
};

}  // namespace ribbon

// Recovery by post-step penetration removal (paper, section 5.6.4, Figure 15).
#pragma once

#include <Eigen/Core>

#include "simulation/detection/bodies.h"

namespace ribbon {

struct RecoveryReport {
  int iterations = 0;         // how often a scheme was applied
  int penetrating_edges = 0;  // distinct edges that still pierce a triangle, of ribbon and obstacle
};

// Lengths that the schemes work with.
struct RecoverySettings {
  double gap_m = 0;   // how far beyond a pierced triangle a particle is moved
  double step_m = 0;  // how far scheme B curls a border at a time
  int patience = 1;   // applications in a row of one scheme that may leave no fewer penetrations

  // For a ribbon whose shortest edge is so long.
  static RecoverySettings of_edge(double edge_m) {
    return {.gap_m = 0.1 * edge_m, .step_m = 0.5 * edge_m};
  }
};

// How many distinct edges pierce a triangle: ribbon into ribbon, ribbon into obstacle and obstacle
// into ribbon.
int count_penetrating_edges(Bodies& bodies, const Eigen::Matrix3Xd& positions);

// Applies schemes A, B and C until no penetration is left or they bring no further improvement.
RecoveryReport recover(Bodies& bodies, const RecoverySettings& settings,
                       Eigen::Matrix3Xd& positions);

}  // namespace ribbon

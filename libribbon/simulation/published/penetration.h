// Detecting errors: edges that pierce triangles (paper, section 5.6.2).
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "simulation/detection/candidate_pair.h"
#include "simulation/detection/collision_surface.h"
#include "simulation/detection/hierarchy.h"

namespace ribbon {

// An edge of one surface that pierces a triangle of another (or of the same) surface.
struct Penetration {
  int edge = 0;      // of the first surface
  int triangle = 0;  // of the second
  Eigen::Vector3d point;
};

// All edges of `surface` that pierce a triangle of it. `hierarchy` is refitted to the positions.
std::vector<Penetration> self_penetrations(const CollisionSurface& surface, Hierarchy& hierarchy,
                                           Hierarchy::Spare spare,
                                           const Eigen::Matrix3Xd& positions);

// All edges of a first surface that pierce a triangle of a second, and the other way round.
struct MutualPenetrations {
  std::vector<Penetration> edges_of_first;
  std::vector<Penetration> edges_of_second;
};

// `first_hierarchy` is refitted; `second` is the still obstacle.
MutualPenetrations mutual_penetrations(const CollisionSurface& first, Hierarchy& first_hierarchy,
                                       const CollisionSurface& second,
                                       const Hierarchy& second_hierarchy,
                                       const Eigen::Matrix3Xd& positions);

// How many different edges the penetrations are about.
int distinct_edges(const std::vector<Penetration>& penetrations);

}  // namespace ribbon

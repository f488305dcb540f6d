// Detecting penetrations: edges that pierce triangles (paper, section 5.6.2).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/detection/bodies.h"

namespace ribbon {

// An edge of one surface that pierces a triangle of another (or of the same) surface.
struct Penetration {
  int edge = 0;      // of the first surface
  int triangle = 0;  // of the second
  Eigen::Vector3d point;
};

// All edges of the ribbon that pierce a triangle of it. `bvh` is refitted to the positions (3
// x particles).
std::vector<Penetration> self_penetrations(const CollisionSurface& ribbon, TriangleBvh& bvh,
                                           TriangleBvh::Spare spare,
                                           const Eigen::Matrix3Xd& positions);

// All edges of the ribbon that pierce a triangle of the obstacle, and the other way round.
struct MutualPenetrations {
  std::vector<Penetration> edges_of_ribbon;
  std::vector<Penetration> edges_of_obstacle;
};

// `bvh`, of the ribbon, is refitted to the positions (3 x particles).
MutualPenetrations mutual_penetrations(const CollisionSurface& ribbon, TriangleBvh& bvh,
                                       const ObstacleBody& obstacle,
                                       const Eigen::Matrix3Xd& positions);

// How many different edges the penetrations are about.
int distinct_edges(const std::vector<Penetration>& penetrations);

}  // namespace ribbon

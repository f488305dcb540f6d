// Where the ribbon meets itself or the obstacle.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "simulation/detection/bodies.h"

namespace ribbon {

struct MeetingPlace {
  int particle = 0;  // of the ribbon, next to the place
  int other = 0;     // another one, or (from the particle count on) a vertex of the obstacle
};

// The first place where an edge pierces a triangle, of the ribbon or of ribbon and obstacle.
std::optional<MeetingPlace> first_intersection(Bodies& bodies, const Eigen::Matrix3Xd& positions);

// The first place where two features that share no vertex, at least one of them the ribbon's, are
// less than distance_m apart. Piercing features need not be near each other.
std::optional<MeetingPlace> first_closer_than(double distance_m, Bodies& bodies,
                                              const Eigen::Matrix3Xd& positions);

}  // namespace ribbon

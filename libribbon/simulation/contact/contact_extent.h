// How much of the ribbon is in contact.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "geometry/rest_size.h"
#include "simulation/contact/pair_distances.h"
#include "simulation/detection/bodies.h"

namespace ribbon {

struct ContactExtent {
  double share = 0;      // of the rows, that touch another part of the ribbon or the obstacle
  double knotted_m = 0;  // rest length from the first to the last row that touches the ribbon
  // Rest lengths from the first end to that first row, and from the last row to the second end;
  // nothing where no row touches the ribbon.
  std::array<std::optional<double>, 2> loose_ends_m;
};

// Rows touch where two features that are not of neighbouring quads lie within one and a half times
// the distance at which contact with the gate begins: what rests on something rests at about that
// distance, or nearer as published. Quads that shear bring neighbours as near. positions: 3 x
// particles. Costs a detection; `bodies` are refitted to the positions.
ContactExtent contact_extent(Bodies& bodies, const RestSize& size, const PairDistances& distances,
                             const Eigen::Matrix3Xd& positions);

}  // namespace ribbon

// What numbers can hold: scenes whose own numbers would break a promise are refused.
#pragma once

#include <Eigen/Core>

#include "result/result.h"
#include "scene/scene.h"
#include "simulation/deformation.h"

namespace ribbon {

// Steps that the springs divide into more parts than these are refused: they would seem to hang.
constexpr int most_substeps = 10'000;

// positions: 3 x vertices, the ribbon of `size` and then the obstacle. Fails, naming the setting
// and its limit, where
// - the springs and the air divide a step into too many parts,
// - a position is not finite or so far from the origin that arithmetic would blur the gap that the
//   gate keeps (a thousandth of it),
// - recorded coordinates, in single precision, cannot hold recording.max_position_error,
// - what recording may move a coordinate by uses up that gap (not with contact = "paper", which
//   keeps none).
Result<void> check_limits(const Scene& scene, const NaturalSize& size, int substeps,
                          const Eigen::Matrix3Xd& positions);

}  // namespace ribbon

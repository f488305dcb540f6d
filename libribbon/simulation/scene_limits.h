// What numbers can hold: scenes whose own numbers would break a promise are refused.
#pragma once

#include <Eigen/Core>

#include "result/result.h"
#include "scene/scene.h"
#include "simulation/deformation.h"

namespace ribbon {

// Contact acts once a step, the springs in each part. Springs that swing many times between two
// contacts turn what contact strains into motion: with more than some 55 parts of rk4, 90 of
// symplectic_euler, strain is no longer bounded.
constexpr int most_substeps = 50;

// positions: 3 x vertices, the ribbon of `size` and then the obstacle. Fails, naming the setting
// and its limit, where
// - a position is not finite or so far from the origin that arithmetic would blur the gap that the
//   gate keeps (a thousandth of it),
// - recorded coordinates, in single precision, cannot hold recording.max_position_error,
// - what recording may move a coordinate by uses up that gap (not with contact = "paper", which
//   keeps none).
Result<void> check_precision(const Scene& scene, const NaturalSize& size,
                             const Eigen::Matrix3Xd& positions);

// Fails where springs and air divide a step into more than most_substeps parts.
Result<void> check_substeps(const Scene& scene, int substeps);

}  // namespace ribbon

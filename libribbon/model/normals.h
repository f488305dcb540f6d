// Normals at the vertices of a mesh.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// One for each of `positions` (3 x vertices), of length 1: the mean over the faces around it,
// weighted by area. Faces are triangles, or quads that a fan from their first corner splits. Where
// they say nothing, because their area is 0, it is `otherwise`.
Eigen::Matrix3Xf vertex_normals(const Eigen::Matrix3Xf& positions, const Eigen::MatrixXi& faces,
                                const Eigen::Vector3f& otherwise);

}  // namespace ribbon

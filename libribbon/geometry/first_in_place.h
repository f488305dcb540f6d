// Vertices that meshes repeat.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace ribbon {

// For each vertex (3 x V) the first one that is in exactly the same place: meshes repeat vertices
// where texture or normals change.
std::vector<int> first_in_place(const Eigen::Matrix3Xf& vertices);

}  // namespace ribbon

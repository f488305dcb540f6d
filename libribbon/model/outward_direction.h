// Which way is outwards where several faces come together?
#pragma once

#include <Eigen/Core>
#include <vector>

namespace ribbon {

struct OutwardDirection {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // of length 1
  // Of the angles between it and the faces' normals. Not above 0: there is no direction that looks
  // away from all faces, as at a corner of crumpled cloth.
  double least_cosine = -1;
};

// The mean of the normals (of length 1) where that looks clearly away from all faces; otherwise the
// direction that does so most: the middle of the smallest cap of the sphere that holds all normals.
OutwardDirection outward_direction(const std::vector<Eigen::Vector3d>& normals);

}  // namespace ribbon

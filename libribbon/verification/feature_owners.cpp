#include "verification/feature_owners.h"

#include <algorithm>
#include <set>
#include <utility>

namespace ribbon {

FeatureOwners::FeatureOwners(const Eigen::Matrix3Xi& triangles)
    : corners_(triangles.cols()), edges_(triangles.cols()) {
  std::set<int> corners;
  std::set<std::pair<int, int>> edges;
  for (int triangle = 0; triangle < triangles.cols(); ++triangle)
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(triangles(k, triangle), triangles((k + 1) % 3, triangle));
      corners_[triangle][k] = corners.insert(triangles(k, triangle)).second;
      edges_[triangle][k] = edges.emplace(a, b).second;
    }
}

}  // namespace ribbon

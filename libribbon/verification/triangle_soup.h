// What is verified: triangles over recorded points.
#pragma once

#include <Eigen/Core>

namespace ribbon {

// The first `judged` triangles (the ribbon) are verified against each other and against the rest
// (the obstacle); the rest is not verified against itself.
struct TriangleSoup {
  Eigen::Matrix3Xf points;     // finite
  Eigen::Matrix3Xi triangles;  // indices of points; a judged triangle has three different ones
  int judged = 0;

  [[nodiscard]] Eigen::Vector3f corner(int triangle, int k) const {
    return points.col(triangles(k, triangle));
  }
};

// Two triangles of a soup, first < second.
struct TrianglePair {
  int first = 0;
  int second = 0;
  bool operator==(const TrianglePair&) const = default;
  bool operator<(const TrianglePair& pair) const {
    return first != pair.first ? first < pair.first : second < pair.second;
  }
};

}  // namespace ribbon

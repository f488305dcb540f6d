// Which triangle looks after which corner and edge, so that no feature is measured twice.
#pragma once

#include <array>
#include <vector>

#include "verification/triangle_soup.h"

namespace ribbon {

// Every vertex of a triangle, and every edge, belongs to the first triangle that has it.
class FeatureOwners {
 public:
  explicit FeatureOwners(const Eigen::Matrix3Xi& triangles);

  [[nodiscard]] bool owns_corner(int triangle, int k) const { return has(corners_, triangle, k); }
  // Edge k joins corners k and (k + 1) % 3.
  [[nodiscard]] bool owns_edge(int triangle, int k) const { return has(edges_, triangle, k); }

 private:
  using Flags = std::vector<std::array<bool, 3>>;
  static bool has(const Flags& flags, int triangle, int k) { return flags[triangle][k]; }

  Flags corners_;
  Flags edges_;
};

}  // namespace ribbon

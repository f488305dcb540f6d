#include "simulation/detection/triangle_fans.h"

#include <numeric>

namespace ribbon {

TriangleFans::TriangleFans(const Eigen::Matrix3Xi& triangles, Eigen::Index vertex_count)
    : corners_(triangles.size()), begins_(vertex_count + 1) {
  for (const int vertex : triangles.reshaped()) ++begins_[vertex + 1];
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  std::vector<std::size_t> ends(begins_.begin(), begins_.end() - 1);
  for (const auto& triangle : triangles.colwise())
    for (int c = 0; c < 3; ++c)
      corners_[ends[triangle[c]]++] = {triangle[(c + 1) % 3], triangle[(c + 2) % 3]};
}

}  // namespace ribbon

// The triangles around each vertex of a surface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ribbon {

// Of any triangles, however bad. Where many meet, as in the tip of a cone, of each fan 64 to 127,
// evenly spread: who asks all triangles there about all others would ask for hours.
class TriangleFans {
 public:
  // The two other corners of a triangle.
  using Corners = std::array<int, 2>;

  // triangles: 3 x T, of so many vertices.
  TriangleFans(const Eigen::Matrix3Xi& triangles, Eigen::Index vertex_count);

  [[nodiscard]] std::span<const Corners> of(int vertex) const {
    return std::span(corners_).subspan(begins_[vertex], begins_[vertex + 1] - begins_[vertex]);
  }

 private:
  std::vector<Corners> corners_;  // of all vertices, one after the other
  std::vector<std::size_t> begins_;
};

}  // namespace ribbon

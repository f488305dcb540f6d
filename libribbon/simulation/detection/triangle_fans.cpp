#include "simulation/detection/triangle_fans.h"

#include <algorithm>

namespace ribbon {

namespace {

constexpr std::size_t most_asked = 64;

// Of a fan of so many triangles each so-manieth is kept.
std::size_t spacing(std::size_t count) {
  return std::max<std::size_t>(1, count / most_asked);
}

}  // namespace

TriangleFans::TriangleFans(const Eigen::Matrix3Xi& triangles, Eigen::Index vertex_count)
    : begins_(vertex_count + 1) {
  std::vector<std::size_t> counts(vertex_count);
  for (const int vertex : triangles.reshaped()) ++counts[vertex];
  for (std::size_t vertex = 0; vertex < counts.size(); ++vertex) {
    const std::size_t step = spacing(counts[vertex]);
    begins_[vertex + 1] = begins_[vertex] + (counts[vertex] + step - 1) / step;
  }
  corners_.resize(begins_.back());
  std::vector<std::size_t> seen(vertex_count);
  for (const auto& triangle : triangles.colwise())
    for (int c = 0; c < 3; ++c) {
      const int vertex = triangle[c];
      const std::size_t step = spacing(counts[vertex]);
      const std::size_t number = seen[vertex]++;
      if (number % step == 0)
        corners_[begins_[vertex] + number / step] = {triangle[(c + 1) % 3], triangle[(c + 2) % 3]};
    }
}

}  // namespace ribbon

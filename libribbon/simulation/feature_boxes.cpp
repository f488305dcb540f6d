#include "simulation/feature_boxes.h"

namespace ribbon {

void FeatureBoxes::refit(const CollisionSurface& surface, std::span<const MovingBox> ranges) {
  const auto range = [&](int vertex) -> const MovingBox& {
    return ranges[static_cast<std::size_t>(vertex)];
  };
  edges.clear();
  for (const auto& [a, b] : surface.edges) {
    edges.push_back(range(a));
    edges.back().include(range(b));
  }
  triangles.clear();
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
    triangles.push_back(range(surface.triangles(0, t)));
    triangles.back().include(range(surface.triangles(1, t)));
    triangles.back().include(range(surface.triangles(2, t)));
  }
}

}  // namespace ribbon

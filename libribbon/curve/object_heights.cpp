#include "curve/object_heights.h"

#include <memory>
#include <utility>

#include "curve/axis_view.h"

namespace ribbon {

namespace {

LinesOfSight lines_of_sight(const TriangleMesh& object, const CurveScene& scene) {
  Eigen::Matrix3Xd seen(3, object.vertices.cols());
  for (Eigen::Index i = 0; i < seen.cols(); ++i) {
    seen.col(i) = as_seen(object.vertices.col(i).cast<double>(), scene.axis) / scene.unit_m;
    seen.col(i).head<2>() += scene.origin;
  }
  return {std::move(seen), object.triangles};
}

}  // namespace

// Most drawings never ask.
ObjectHeights heights_of(const std::optional<TriangleMesh>& object, const CurveScene& scene) {
  if (!object) return {};
  return [&object, &scene,
          lines = std::shared_ptr<const LinesOfSight>()](const Eigen::Vector2d& place) mutable {
    if (!lines) lines = std::make_shared<const LinesOfSight>(lines_of_sight(*object, scene));
    return lines->through(place);
  };
}

}  // namespace ribbon

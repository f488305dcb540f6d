// The axis of an object: what a ribbon is fastened towards, and where it runs inside the object.
#pragma once

#include <optional>
#include <vector>

#include "geometry/centre_axis.h"
#include "geometry/triangle_mesh.h"
#include "geometry/vectors.h"

namespace ribbon {

// Heights are metres along `line`, from its point in its direction.
struct ObjectAxis {
  struct Stretch {
    double low_m;
    double high_m;
  };

  CentreAxis line;
  std::vector<Stretch> inside;  // the object, ascending; at least one

  [[nodiscard]] double height_m(const Eigen::Vector3d& point) const {
    return dot(line.direction, point - line.point_m);
  }
  [[nodiscard]] bool is_inside(double height_m) const;
  // From the object's first to its last stretch, with what lies between.
  [[nodiscard]] Stretch extent() const { return {inside.front().low_m, inside.back().high_m}; }
};

// The centre axis or, where it misses the object, its parallel through the middle of the object's
// bounding box. Nothing where that is not in the object either (it may be a ring), and without an
// axis or an object: then nothing can be said of turns round the object. Stretches shorter than a
// fiftieth of the object may be missed.
std::optional<ObjectAxis> object_axis(const std::optional<CentreAxis>& centre_axis,
                                      const std::optional<TriangleMesh>& object);

}  // namespace ribbon

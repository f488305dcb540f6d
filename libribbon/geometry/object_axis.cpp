#include "geometry/object_axis.h"

#include <algorithm>
#include <cmath>

#include "geometry/vectors.h"
#include "geometry/winding_number.h"

namespace ribbon {

namespace {

constexpr int samples = 50;
constexpr int halvings = 20;  // of the distance between two samples, to find a border

class AxisInObject {
 public:
  AxisInObject(const CentreAxis& line, const TriangleMesh& object) : line_(line), object_(object) {}

  [[nodiscard]] std::vector<ObjectAxis::Stretch> stretches() const {
    Eigen::VectorXd heights_m(object_.vertices.cols());
    for (Eigen::Index k = 0; k < heights_m.size(); ++k)
      heights_m[k] = dot(line_.direction, object_.vertices.col(k).cast<double>() - line_.point_m);
    const double low_m = heights_m.minCoeff();
    const double spacing_m = (heights_m.maxCoeff() - low_m) / samples;
    std::vector<ObjectAxis::Stretch> result;
    bool was_inside = false;
    // The last sample lies beyond the object, as the one before the first does.
    for (int k = 0; k <= samples; ++k) {
      const double sample_m = low_m + (k + 0.5) * spacing_m;
      const bool now_inside = is_inside(sample_m);
      if (now_inside && !was_inside)
        result.push_back({border_m(sample_m, sample_m - spacing_m), sample_m});
      if (!now_inside && was_inside)
        result.back().high_m = border_m(sample_m - spacing_m, sample_m);
      was_inside = now_inside;
    }
    return result;
  }

 private:
  [[nodiscard]] bool is_inside(double height_m) const {
    const Eigen::Vector3d point = line_.point_m + height_m * line_.direction;
    return std::abs(winding_number(object_, point)) > 0.5;
  }

  [[nodiscard]] double border_m(double inside_m, double outside_m) const {
    for (int k = 0; k < halvings; ++k) {
      const double middle_m = (inside_m + outside_m) / 2;
      (is_inside(middle_m) ? inside_m : outside_m) = middle_m;
    }
    return inside_m;
  }

  const CentreAxis& line_;
  const TriangleMesh& object_;
};

}  // namespace

bool ObjectAxis::is_inside(double height_m) const {
  return std::any_of(inside.begin(), inside.end(), [&](const Stretch& stretch) {
    return stretch.low_m < height_m && height_m < stretch.high_m;
  });
}

std::optional<ObjectAxis> object_axis(const std::optional<CentreAxis>& centre_axis,
                                      const std::optional<TriangleMesh>& object) {
  if (!centre_axis || !object || object->triangles.cols() == 0) return std::nullopt;
  const Eigen::Vector3d middle = (object->vertices.rowwise().minCoeff().cast<double>() +
                                  object->vertices.rowwise().maxCoeff().cast<double>()) /
                                 2;
  for (const Eigen::Vector3d& point : {centre_axis->point_m, middle}) {
    ObjectAxis axis{{point, centre_axis->direction}, {}};
    axis.inside = AxisInObject(axis.line, *object).stretches();
    if (!axis.inside.empty()) return axis;
  }
  return std::nullopt;
}

}  // namespace ribbon

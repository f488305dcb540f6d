#include "model/outward_direction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

namespace ribbon {

namespace {

using Normals = std::vector<Eigen::Vector3d>;

constexpr double clear_cosine = 0.1;

class BestDirection {
 public:
  explicit BestDirection(const Normals& normals) : normals_(normals) {}

  void consider(const Eigen::Vector3d& towards) {
    const double length = towards.norm();
    if (length < 1e-9) return;  // the normals say nothing
    const Eigen::Vector3d direction = towards / length;
    double least = 1;
    for (const Eigen::Vector3d& normal : normals_) least = std::min(least, normal.dot(direction));
    if (least > best_.least_cosine) best_ = {.direction = direction, .least_cosine = least};
  }

  [[nodiscard]] const OutwardDirection& best() const { return best_; }

 private:
  const Normals& normals_;
  OutwardDirection best_;
};

// The smallest cap has one, two or three normals on its border and its middle between them.
void consider_middles_of_caps(const Normals& normals, BestDirection& best) {
  for (std::size_t a = 0; a < normals.size(); ++a) {
    best.consider(normals[a]);
    for (std::size_t b = 0; b < a; ++b) {
      best.consider(normals[a] + normals[b]);
      for (std::size_t c = 0; c < b; ++c) {
        const Eigen::Vector3d middle = (normals[b] - normals[a]).cross(normals[c] - normals[a]);
        best.consider(middle);
        best.consider(-middle);
      }
    }
  }
}

}  // namespace

OutwardDirection outward_direction(const Normals& normals) {
  BestDirection best(normals);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& normal : normals) sum += normal;
  best.consider(sum);
  if (best.best().least_cosine < clear_cosine) consider_middles_of_caps(normals, best);
  return best.best();
}

}  // namespace ribbon

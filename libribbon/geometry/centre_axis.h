// The line that a ribbon is fastened towards (paper, section 5.2).
#pragma once

#include <Eigen/Core>

namespace ribbon {

struct CentreAxis {
  Eigen::Vector3d point_m;    // a point on it
  Eigen::Vector3d direction;  // unit length

  bool operator==(const CentreAxis&) const = default;
};

}  // namespace ribbon

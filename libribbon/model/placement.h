// In which axes, unit and size a recording is exported.
#pragma once

#include <Eigen/Core>

namespace ribbon {

enum class UpAxis { y, z };

// Recordings are in metres, right-handed, y up; so is the default.
struct Placement {
  UpAxis up = UpAxis::y;       // z: (x, y, z) becomes (x, -z, y)
  double metres_per_unit = 1;  // what a coordinate of 1 means
  double scale = 1;            // of the exported thing to the recorded one

  // Of exported coordinates to recorded ones.
  [[nodiscard]] double factor() const { return scale / metres_per_unit; }

  // Recorded positions (3 x vertices) as they are exported. Each coordinate is rounded once, and
  // not at all where metres and scale are as recorded.
  [[nodiscard]] Eigen::Matrix3Xf place(const Eigen::Matrix3Xf& recorded) const;

  // A bound on how far that moves any of them, in recorded metres.
  [[nodiscard]] double rounding_m(const Eigen::Matrix3Xf& recorded) const;
};

}  // namespace ribbon

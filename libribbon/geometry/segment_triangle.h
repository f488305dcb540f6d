// Does an edge pierce a triangle?
#pragma once

#include <Eigen/Core>
#include <optional>

namespace ribbon {

// Where segment pq pierces triangle abc.
struct Piercing {
  Eigen::Vector3d weights;  // barycentric weights of a, b, c
};

// The piercing point of segment pq and triangle abc, if there is one. Segments within the
// triangle's plane do not pierce. Evaluated in double precision, not exactly.
std::optional<Piercing> pierce(const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                               const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                               const Eigen::Vector3d& c);

}  // namespace ribbon

// Friction between the two features of a collision. The paper has none (section 5.3).
#pragma once

#include <Eigen/Core>

namespace ribbon {

// Coulomb's law, for impulses as for displacements: the change of `sliding`, a relative velocity or
// displacement of the contact points, that friction brings about. It acts against the part of
// `sliding` across the unit `normal`, stops it at most, and is not larger than `coefficient` (>= 0)
// times `pressed`, the change that the collision brings about along the normal (>= 0).
Eigen::Vector3d friction_impulse(const Eigen::Vector3d& sliding, const Eigen::Vector3d& normal,
                                 double coefficient, double pressed);

}  // namespace ribbon

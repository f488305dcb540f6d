// Springs to be reckoned with by hand.
#pragma once

#include <Eigen/Core>

#include "ribbon_mesh/springs.h"

namespace ribbon {

// One spring between two particles.
inline SpringNetwork one_spring(double stiffness, double rest_length_m) {
  SpringNetwork network{.grid = {2, 1}};
  network.stretch = {stiffness, {{{1, 0, rest_length_m}, {0, 1, rest_length_m}}}};
  return network;
}

// Calls visit(a, b, rest_length_m, stiffness) for all springs, one by one.
template <class Visit>
void for_each_spring(const SpringNetwork& network, const Visit& visit) {
  for (const SpringKind* kind : network.kinds())
    for (const SpringFamily& family : kind->families)
      for_each_spring(network.grid, family,
                      [&](int a, int b) { visit(a, b, family.rest_m(a), kind->stiffness); });
}

inline double elastic_energy_j(const SpringNetwork& network, const Eigen::Matrix3Xd& positions) {
  double sum = 0;
  for_each_spring(network, [&](int a, int b, double rest_length_m, double stiffness) {
    const double elongation = (positions.col(b) - positions.col(a)).norm() - rest_length_m;
    sum += stiffness / 2 * elongation * elongation;
  });
  return sum;
}

}  // namespace ribbon

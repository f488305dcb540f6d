#include "simulation/state/edge_strain.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

using Eigen::Matrix3Xd;

double worst_strain(const RibbonGrid& grid, const SpringFamily& family,
                    const Matrix3Xd& positions) {
  double worst = 0;
  for_each_spring(grid, family, [&](int a, int b) {
    worst = std::max(worst, std::abs(edge_strain(family, a, b, positions)));
  });
  return worst;
}

double worst_strain(const SpringNetwork& springs, const Matrix3Xd& positions) {
  double worst = 0;
  for (const SpringKind* kind : {&springs.stretch, &springs.shear}) {
    if (kind->stiffness == 0) continue;
    for (const SpringFamily& family : kind->families)
      worst = std::max(worst, worst_strain(springs.grid, family, positions));
  }
  return worst;
}

}  // namespace ribbon

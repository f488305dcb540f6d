#include "simulation/published/strain_correction.h"

#include <cmath>

#include "simulation/state/smoothed_directions.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

StrainCorrection::StrainCorrection(const RibbonGrid& grid, double length_m, double width_m,
                                   double limit)
    : grid_(grid),
      along_m_(length_m / (grid.along - 1)),
      across_m_(width_m / (grid.across - 1)),
      limit_(limit) {}

double StrainCorrection::excess_m(double length_m, double natural_m) const {
  // What is over the limit is brought a little within it, so that repeated rounds come to an end.
  const double aim = 0.95 * limit_ * natural_m;
  if (length_m > (1 + limit_) * natural_m) return length_m - natural_m - aim;
  if (length_m < (1 - limit_) * natural_m) return length_m - natural_m + aim;
  return 0;
}

bool StrainCorrection::any_over_limit(const Matrix3Xd& positions) const {
  const auto over = [&](int a, int b, double natural_m) {
    return excess_m((positions.col(b) - positions.col(a)).norm(), natural_m) != 0;
  };
  for (int i = 0; i < grid_.along; ++i) {
    for (int j = 0; j < grid_.across; ++j) {
      const int here = grid_.particle(i, j);
      if (i + 1 < grid_.along && over(here, grid_.particle(i + 1, j), along_m_)) return true;
      if (j + 1 < grid_.across && over(here, grid_.particle(i, j + 1), across_m_)) return true;
    }
  }
  return false;
}

void StrainCorrection::correct_edge(int a, int b, double natural_m, const Vector3d& direction,
                                    Matrix3Xd& positions) const {
  const Vector3d edge = positions.col(b) - positions.col(a);
  const double excess = excess_m(edge.norm(), natural_m);
  if (excess == 0) return;
  // Where the surface is crumpled the smoothed direction says little; then the edge itself serves.
  const double along = direction.dot(edge);
  const Vector3d way = along > 0.5 * direction.norm() * edge.norm() ? direction.normalized()
                       : edge.norm() > 0                            ? edge.normalized()
                                                                    : direction.normalized();
  positions.col(a) += 0.5 * excess * way;
  positions.col(b) -= 0.5 * excess * way;
}

void StrainCorrection::apply(Matrix3Xd& positions) const {
  const Matrix3Xd along = smoothed_directions_along(grid_, positions);
  for (int i = 0; i + 1 < grid_.along; ++i)
    for (int j = 0; j < grid_.across; ++j) {
      const int a = grid_.particle(i, j);
      const int b = grid_.particle(i + 1, j);
      correct_edge(a, b, along_m_, along.col(a) + along.col(b), positions);
    }
  for (int i = 0; i < grid_.along; ++i)
    for (int j = 0; j + 1 < grid_.across; ++j) {
      // Across, the neighbours on either side smooth the direction.
      const int a = grid_.particle(i, j);
      const int b = grid_.particle(i, j + 1);
      const int before = grid_.particle(i, j > 0 ? j - 1 : j);
      const int after = grid_.particle(i, j + 2 < grid_.across ? j + 2 : j + 1);
      correct_edge(a, b, across_m_, positions.col(after) - positions.col(before), positions);
    }
}

}  // namespace ribbon

#include "simulation/published/strain_correction.h"

#include "geometry/vectors.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

PublishedStrainCorrection::PublishedStrainCorrection(const RestSize& size, double limit)
    : grid_(size.grid),
      along_(stretch_families(size)[0]),
      across_(stretch_families(size)[1]),
      limit_(limit),
      tangents_(grid_) {}

double PublishedStrainCorrection::excess_m(double length_m, double rest_length_m) const {
  // What is over the limit is brought a little within it, so that repeated rounds come to an end.
  const double aim = 0.95 * limit_ * rest_length_m;
  if (length_m > (1 + limit_) * rest_length_m) return length_m - rest_length_m - aim;
  if (length_m < (1 - limit_) * rest_length_m) return length_m - rest_length_m + aim;
  return 0;
}

bool PublishedStrainCorrection::any_over_limit(const SpringFamily& family,
                                               const Matrix3Xd& positions) const {
  bool any = false;
  for (int row = 0; row + family.rows < grid_.along && !any; ++row)
    for_each_spring_of_row(grid_, family, row, [&](int a, int b) {
      any = any || excess_m(length_of(positions.col(b) - positions.col(a)), family.rest_m(a)) != 0;
    });
  return any;
}

bool PublishedStrainCorrection::any_over_limit(const Matrix3Xd& positions) const {
  return any_over_limit(along_, positions) || any_over_limit(across_, positions);
}

void PublishedStrainCorrection::correct_edge(int a, int b, double rest_length_m,
                                             const Vector3d& smoothed, Matrix3Xd& positions) const {
  const Vector3d edge = positions.col(b) - positions.col(a);
  const double excess = excess_m(length_of(edge), rest_length_m);
  if (excess == 0) return;
  // Where the surface is crumpled the smoothed direction says little; then the edge itself serves.
  const bool says_little = dot(smoothed, edge) <= 0.5 * length_of(smoothed) * length_of(edge);
  const Vector3d direction =
      says_little && length_of(edge) > 0 ? normalised(edge) : normalised(smoothed);
  positions.col(a) += 0.5 * excess * direction;
  positions.col(b) -= 0.5 * excess * direction;
}

void PublishedStrainCorrection::apply(Matrix3Xd& positions) {
  const Matrix3Xd& directions = tangents_.at(positions);
  for_each_spring(grid_, along_, [&](int a, int b) {
    correct_edge(a, b, along_.rest_m(a), directions.col(a) + directions.col(b), positions);
  });
  for_each_spring(grid_, across_, [&](int a, int b) {
    // Across, the neighbours on either side smooth the direction.
    const int before = grid_.column(a) > 0 ? a - 1 : a;
    const int after = grid_.column(b) + 1 < grid_.across ? b + 1 : b;
    correct_edge(a, b, across_.rest_m(a), positions.col(after) - positions.col(before), positions);
  });
}

}  // namespace ribbon

#include "ribbon_mesh/width_vectors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Curvature vectors about which the line turns at its inner points: cross products of the
// directions of consecutive pieces, divided by the spacing; zero at both ends.
Matrix3Xd turning(const Matrix3Xd& line, double spacing_m) {
  Matrix3Xd result = Matrix3Xd::Zero(3, line.cols());
  for (Eigen::Index i = 1; i + 1 < line.cols(); ++i) {
    const Vector3d before = normalised(line.col(i) - line.col(i - 1));
    const Vector3d after = normalised(line.col(i + 1) - line.col(i));
    result.col(i) = before.cross(after) / spacing_m;
  }
  return result;
}

Matrix3Xd averaged(const Matrix3Xd& values, Eigen::Index reach) {
  Matrix3Xd result(3, values.cols());
  for (Eigen::Index i = 0; i < values.cols(); ++i) {
    const Eigen::Index first = std::max<Eigen::Index>(0, i - reach);
    const Eigen::Index last = std::min<Eigen::Index>(values.cols() - 1, i + reach);
    result.col(i) = mean_of_columns(values.middleCols(first, last - first + 1));
  }
  return result;
}

Vector3d tangent(const Matrix3Xd& line, Eigen::Index i) {
  const Eigen::Index before = std::max<Eigen::Index>(0, i - 1);
  const Eigen::Index after = std::min<Eigen::Index>(line.cols() - 1, i + 1);
  return normalised(line.col(after) - line.col(before));
}

// The unit vector orthogonal to `direction` that is closest to `preferred`.
Vector3d made_orthogonal(const Vector3d& preferred, const Vector3d& direction) {
  const Vector3d rest = preferred - dot(preferred, direction) * direction;
  return length_of(rest) > 1e-9 * length_of(preferred) ? normalised(rest)
                                                       : Vector3d(direction.unitOrthogonal());
}

}  // namespace

Matrix3Xd width_vectors(const Matrix3Xd& centre_line, const Vector3d& axis, double width_m) {
  assert(centre_line.cols() >= 2 && width_m > 0);
  const double spacing_m = length_of(centre_line.col(1) - centre_line.col(0));
  Matrix3Xd preferred = averaged(turning(centre_line, spacing_m), 1);

  // A piece counts as straight when it turns on a larger radius than this many widths.
  const double straight_per_m = 1 / (4 * width_m);
  for (Eigen::Index i = 0; i < preferred.cols(); ++i) {
    if (dot(preferred.col(i), axis) < 0) preferred.col(i) *= -1;
    preferred.col(i) += straight_per_m * axis;
    preferred.col(i) = normalised(preferred.col(i));
  }
  preferred.col(0) = axis;
  // A band that twists within less than its width stretches its selvages, so the preferred
  // directions are smoothed over two widths. Of the reaches tried on the samples this one strains
  // their start least.
  const auto reach = static_cast<Eigen::Index>(std::lround(width_m / spacing_m));
  preferred = averaged(averaged(preferred, reach), reach);
  preferred.col(0) = axis;

  Matrix3Xd result(3, preferred.cols());
  for (Eigen::Index i = 0; i < preferred.cols(); ++i)
    result.col(i) = made_orthogonal(preferred.col(i), tangent(centre_line, i));
  return result;
}

}  // namespace ribbon

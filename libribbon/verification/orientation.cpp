#include "verification/orientation.h"

#include <cmath>

#include "verification/exact_orientation.h"

namespace ribbon {

namespace {

// With u = 2^-53, each of the determinant's products passes at most 9 roundings (three differences,
// two products, one sum within the minor, three at most outside), so that the computed determinant
// is off by less than 10 u times the sum of the products' absolute values, and that sum, computed
// likewise, by less than 10 u of itself. 16 u covers both.
//
// Nothing overflows or underflows: differences of single-precision numbers are 0 or from 2^-149 to
// 2^129 in size, so products of three are 0 or from 2^-447 to 2^387.
constexpr double relative_error = 0x1p-49;

}  // namespace

int side_of_plane(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                  const Eigen::Vector3f& d) {
  const Eigen::Vector3d origin = a.cast<double>();
  const Eigen::Vector3d p = b.cast<double>() - origin;
  const Eigen::Vector3d q = c.cast<double>() - origin;
  const Eigen::Vector3d r = d.cast<double>() - origin;
  const double yz = q.y() * r.z();
  const double zy = q.z() * r.y();
  const double zx = q.z() * r.x();
  const double xz = q.x() * r.z();
  const double xy = q.x() * r.y();
  const double yx = q.y() * r.x();
  const double determinant = p.x() * (yz - zy) + p.y() * (zx - xz) + p.z() * (xy - yx);
  const double size = std::abs(p.x()) * (std::abs(yz) + std::abs(zy)) +
                      std::abs(p.y()) * (std::abs(zx) + std::abs(xz)) +
                      std::abs(p.z()) * (std::abs(xy) + std::abs(yx));
  const double error = relative_error * size;
  if (determinant > error) return 1;
  if (determinant < -error) return -1;
  return size == 0 ? 0 : exact_side_of_plane(a, b, c, d);
}

int turn(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
  const Eigen::Vector2d origin = a.cast<double>();
  const Eigen::Vector2d p = b.cast<double>() - origin;
  const Eigen::Vector2d q = c.cast<double>() - origin;
  const double xy = p.x() * q.y();
  const double yx = p.y() * q.x();
  const double error = relative_error * (std::abs(xy) + std::abs(yx));
  if (xy - yx > error) return 1;
  if (xy - yx < -error) return -1;
  return error == 0 ? 0 : exact_turn(a, b, c);
}

}  // namespace ribbon

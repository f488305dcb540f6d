#include "verification/feature_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ribbon {

namespace {

using Eigen::Vector3d;

// Where a convex shape reaches along a direction: outer bounds of its lowest and highest point.
struct Reach {
  double low;
  double high;

  void include(const Reach& reach) {
    low = std::min(low, reach.low);
    high = std::max(high, reach.high);
  }
};

// Of the point `from_origin` away from the origin, that vector being rounded once. The product
// passes at most 5 roundings (one of them in from_origin) of 2^-53 of its terms' sizes; 16 such are
// allowed for. Nothing underflows: see `unit_like`.
Reach reach(const Vector3d& direction, const Vector3d& from_origin) {
  constexpr double relative_error = 0x1p-49;
  const double height = direction.dot(from_origin);
  const double error = relative_error * direction.cwiseAbs().dot(from_origin.cwiseAbs());
  return {height - error, height + error};
}

// The direction, its largest component 1 or -1 and tiny ones 0, so that products with differences
// of coordinates never underflow; 0 when it is 0 or not finite. Any direction gives a valid bound,
// so changing it a little is allowed.
Vector3d unit_like(const Vector3d& direction) {
  const double size = direction.cwiseAbs().maxCoeff();
  if (!(size > 0) || !std::isfinite(size)) return Vector3d::Zero();
  const Vector3d scaled = direction / size;
  return (scaled.array().abs() < 1e-30).select(0.0, scaled);
}

// The gap between two shapes along `direction`; the corners of each are columns, differences from
// an origin that is one of them.
template <class Shape, class Other>
double gap_along(const Vector3d& any_direction, const Shape& shape, const Other& other) {
  const Vector3d direction = unit_like(any_direction);
  if (direction.isZero(0)) return 0;
  Reach here = reach(direction, shape.col(0));
  Reach there = reach(direction, other.col(0));
  for (int k = 1; k < shape.cols(); ++k) here.include(reach(direction, shape.col(k)));
  for (int k = 1; k < other.cols(); ++k) there.include(reach(direction, other.col(k)));
  const double gap = std::max(there.low - here.high, here.low - there.high);
  // Covers the rounding of this difference, of the length and of the quotient.
  constexpr double slack = 1 - 0x1p-48;
  return gap * slack / direction.norm();
}

// From the point of segment ab that is next to p, to p; any vector when the segment is degenerate.
Vector3d from_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d edge = b - a;
  const double t = (p - a).dot(edge) / edge.squaredNorm();
  return p - a - std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * edge;
}

}  // namespace

// The closest point of a triangle is inside or on an edge: one of these directions is the one from
// it to p, and no other can give more.
double certain_point_triangle_distance(const Eigen::Vector3f& p, const Eigen::Vector3f& a,
                                       const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                                       double enough) {
  const Vector3d origin = p.cast<double>();
  const Vector3d point = Vector3d::Zero();
  Eigen::Matrix3d triangle;
  triangle << a.cast<double>() - origin, b.cast<double>() - origin, c.cast<double>() - origin;
  const Vector3d normal =
      (triangle.col(1) - triangle.col(0)).cross(triangle.col(2) - triangle.col(0));
  double distance = std::max(0.0, gap_along(normal, point, triangle));
  for (int k = 0; k < 3 && distance < enough; ++k) {
    const Vector3d direction = from_segment(point, triangle.col(k), triangle.col((k + 1) % 3));
    distance = std::max(distance, gap_along(direction, point, triangle));
  }
  return distance;
}

// The closest points of two segments are both inside, and then the direction between them is
// perpendicular to both, or one of them is an end.
double certain_segments_distance(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                                 const Eigen::Vector3f& c, const Eigen::Vector3f& d,
                                 double enough) {
  const Vector3d origin = a.cast<double>();
  Eigen::Matrix<double, 3, 2> segment;
  Eigen::Matrix<double, 3, 2> other;
  segment << Vector3d::Zero(), b.cast<double>() - origin;
  other << c.cast<double>() - origin, d.cast<double>() - origin;
  const Vector3d normal = segment.col(1).cross(other.col(1) - other.col(0));
  double distance = std::max(0.0, gap_along(normal, segment, other));
  for (int k = 0; k < 4 && distance < enough; ++k) {
    const int end = k / 2;
    const Vector3d direction = k % 2 == 0
                                   ? from_segment(segment.col(end), other.col(0), other.col(1))
                                   : from_segment(other.col(end), segment.col(0), segment.col(1));
    distance = std::max(distance, gap_along(direction, segment, other));
  }
  return distance;
}

}  // namespace ribbon

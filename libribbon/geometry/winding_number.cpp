#include "geometry/winding_number.h"

#include <Eigen/Geometry>
#include <numbers>

#include "geometry/angles.h"
#include "geometry/vectors.h"

namespace ribbon {

namespace {

// Half the solid angle of a triangle, its corners seen from the origin (van Oosterom and Strackee,
// "The solid angle of a plane triangle", 1983).
double half_solid_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                        const Eigen::Vector3d& c) {
  const double a_m = length_of(a);
  const double b_m = length_of(b);
  const double c_m = length_of(c);
  return polar_angle(a_m * b_m * c_m + dot(a, b) * c_m + dot(b, c) * a_m + dot(c, a) * b_m,
                     dot(a, b.cross(c)));
}

}  // namespace

double winding_number(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles.colwise()) {
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return mesh.vertices.col(triangle[k]).cast<double>() - point;
    };
    sum += half_solid_angle(corner(0), corner(1), corner(2));
  }
  return sum / (2 * std::numbers::pi);
}

}  // namespace ribbon

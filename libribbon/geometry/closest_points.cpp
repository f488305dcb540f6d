#include "geometry/closest_points.h"

#include <algorithm>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Parameter in [0, 1] of the point of segment ab that is closest to p.
double closest_on_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d ab = b - a;
  const double squared_length = squared_length_of(ab);
  return squared_length > 0 ? std::clamp(dot(ab, p - a) / squared_length, 0.0, 1.0) : 0.0;
}

}  // namespace

Vector3d closest_on_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                             const Vector3d& c) {
  // Solve for the foot of the perpendicular in the triangle's plane first.
  const Vector3d ab = b - a;
  const Vector3d ac = c - a;
  const Vector3d ap = p - a;
  const double bb = squared_length_of(ab);
  const double bc = dot(ab, ac);
  const double cc = squared_length_of(ac);
  const double pb = dot(ab, ap);
  const double pc = dot(ac, ap);
  const double determinant = bb * cc - bc * bc;
  // Where the corner at a is sharper than 1e-6 rounding decides about the foot: the border serves.
  if (determinant > 1e-12 * bb * cc) {
    const double v = (cc * pb - bc * pc) / determinant;
    const double w = (bb * pc - bc * pb) / determinant;
    if (v >= 0 && w >= 0 && v + w <= 1) return {1 - v - w, v, w};
  }
  // The foot lies outside: the closest point is on the border.
  const double on_ab = closest_on_segment(p, a, b);
  const double on_bc = closest_on_segment(p, b, c);
  const double on_ca = closest_on_segment(p, c, a);
  const double to_ab = squared_length_of(a + on_ab * ab - p);
  const double to_bc = squared_length_of(b + on_bc * (c - b) - p);
  const double to_ca = squared_length_of(c + on_ca * (a - c) - p);
  if (to_ab <= to_bc && to_ab <= to_ca) return {1 - on_ab, on_ab, 0};
  if (to_bc <= to_ca) return {0, 1 - on_bc, on_bc};
  return {on_ca, 0, 1 - on_ca};
}

Vector2d closest_on_segments(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                             const Vector3d& d) {
  const Vector3d u = b - a;
  const Vector3d v = d - c;
  const Vector3d r = a - c;
  const double uu = squared_length_of(u);
  const double uv = dot(u, v);
  const double vv = squared_length_of(v);
  const double ur = dot(u, r);
  const double vr = dot(v, r);
  const double determinant = uu * vv - uv * uv;
  // Nearly parallel lines have no unique closest pair: any s serves, the clamps below do the rest.
  double s =
      determinant > 1e-14 * uu * vv ? std::clamp((uv * vr - vv * ur) / determinant, 0.0, 1.0) : 0.0;
  double t = vv > 0 ? (uv * s + vr) / vv : 0.0;
  if (vv == 0 || t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = uu > 0 ? std::clamp((uv * t - ur) / uu, 0.0, 1.0) : 0.0;
  }
  return {s, t};
}

}  // namespace ribbon

#include "knot/type/closed_by_rays.h"

#include "knot/type/jones_polynomial.h"
#include "knot/type/knot_diagram.h"
#include "knot/type/simplify_curve.h"

namespace ribbon {

std::optional<LaurentPolynomial> type_closed_by(const std::array<Eigen::Vector3d, 2>& rays,
                                                const Eigen::Matrix3Xd& curve) {
  LongCurve closed{ProjectivePoint::direction(rays[0])};
  for (const auto& point : curve.colwise()) closed.push_back(ProjectivePoint::point(point));
  closed.push_back(ProjectivePoint::direction(rays[1]));
  const auto diagram = simple_diagram(simplified(closed));
  if (!diagram) return std::nullopt;
  return jones_polynomial(*diagram);
}

}  // namespace ribbon

// Which knot a curve is when rays from its two ends to the far close it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "knot/type/laurent_polynomial.h"

namespace ribbon {

// curve: 3 x at least 2 points in general position; rays: outwards from its first and its last
// point, of any length but not of one direction. Nothing where a ray meets the curve, or where the
// knot is too tangled.
std::optional<LaurentPolynomial> type_closed_by(const std::array<Eigen::Vector3d, 2>& rays,
                                                const Eigen::Matrix3Xd& curve);

}  // namespace ribbon

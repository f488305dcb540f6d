// Which way the width of the ribbon points along its centre line (paper, section 4.2).
#pragma once

#include <Eigen/Core>

namespace ribbon {

// Unit vectors, one a point, orthogonal to the centre line. centre_line: 3 x N (N >= 2) evenly
// spaced points in metres; axis: unit vector along which crossings were pulled apart; width_m > 0.
//
// Each is the average of the three neighbouring cross products of consecutive pieces, so that the
// band bends about its width and is not stretched along one selvage. Where the curve is nearly
// straight compared with the width the cross products say nothing: there the vector leans to the
// axis. It stays on the axis' side throughout, so that an inflection does not turn the band over.
// The first vector is the axis itself made orthogonal to the curve; the last averages what is left
// of its cross products (footnote 1).
Eigen::Matrix3Xd width_vectors(const Eigen::Matrix3Xd& centre_line, const Eigen::Vector3d& axis,
                               double width_m);

}  // namespace ribbon

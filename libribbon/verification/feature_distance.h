// Distances that are certainly not smaller than they are said to be.
#pragma once

#include <Eigen/Core>
#include <limits>

namespace ribbon {

// Lower bounds of the distance between a point and a triangle and between two segments, in metres,
// at least 0. Rigorous: each is the width of a gap between two parallel planes that keep the two
// shapes apart, computed in double precision and then made smaller by more than all rounding can
// have added. The planes are placed so well that the bound falls short of the true distance by
// about its rounding only. Coordinates must be finite; shapes may be degenerate.
//
// Whoever only wants to know whether the distance is below `enough` asks for less work: a bound
// that is not below it need not be the best one.
double certain_point_triangle_distance(const Eigen::Vector3f& p, const Eigen::Vector3f& a,
                                       const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                                       double enough = std::numeric_limits<double>::infinity());
double certain_segments_distance(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                                 const Eigen::Vector3f& c, const Eigen::Vector3f& d,
                                 double enough = std::numeric_limits<double>::infinity());

}  // namespace ribbon

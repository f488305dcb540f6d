// Do two triangles meet? Touching counts, and the answers are certain.
#pragma once

#include <Eigen/Core>

#include "verification/triangle_soup.h"

namespace ribbon {

// Have segment pq and triangle abc a point in common, the ends and borders included? Either may be
// degenerate: a triangle without area is the segment or point that is left of it. Exact.
bool segment_meets_triangle(const Eigen::Vector3f& p, const Eigen::Vector3f& q,
                            const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                            const Eigen::Vector3f& c);

// Have a corner, an edge or the inside of one triangle and one of the other a point in common,
// other than features that share a vertex? So
// - triangles without a common vertex must not touch at all,
// - triangles with one may have nothing else in common,
// - triangles with a common edge may not be folded onto each other,
// - triangles with the same three vertices always meet.
// Different vertices in the same position touch. Exact.
bool triangles_meet(const TriangleSoup& soup, const TrianglePair& pair);

}  // namespace ribbon

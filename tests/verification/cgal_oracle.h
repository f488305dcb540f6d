// The second opinion of the tests: CGAL's exact predicates.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/ribbon_grid.h"
#include "verification/triangle_soup.h"

namespace ribbon {

// The pairs of a judged triangle and any other that meet (ascending): CGAL's box intersection finds
// candidates, CGAL's kernel decides. Features that share a vertex are not compared: every other
// feature of one triangle is, with every feature of the other.
std::vector<TrianglePair> cgal_intersecting_pairs(const TriangleSoup& soup);

// The intersecting pairs of a ribbon alone, as CGAL's self-intersection test of meshes sees them.
// Nothing when a triangle has no area: that test leaves such triangles out.
std::optional<std::vector<TrianglePair>> cgal_self_intersections(const RibbonGrid& grid,
                                                                 const Eigen::Matrix3Xf& positions);

}  // namespace ribbon

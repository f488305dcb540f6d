// Do the closest points of two features tell how the surfaces lie there?
#pragma once

#include <Eigen/Core>

#include "simulation/detection/bodies.h"
#include "simulation/detection/feature_pairs.h"
#include "simulation/detection/vertex_positions.h"

namespace ribbon {

// Of features beside each other the closest points lie on borders, and the line between them lies
// aslant, although a neighbour of the one, often on the same flat surface, is closer to the other:
// such a pair says nothing of how the surfaces touch (Ericson, "Real-time collision detection",
// 2005, section 5.1: a point belongs to the feature in whose Voronoi region it lies).
//
// Answers for the pair's points of these weights (as closest_weights() gives them), the first of
// which lies in `direction` (of length 1) from the second. Of edges they are where neither is an
// end: for ends polygons answer. Of a triangle, where no neighbour of the point on its border is
// closer, and so, but for what is nearly flat, of an edge or a vertex of the obstacle. Neighbours
// of the ribbon's edge or vertex may be: cloth bends, and each of them answers for itself.
bool are_locally_closest(const FeaturePair& pair, const Eigen::Vector4d& weights,
                         const Eigen::Vector3d& direction, const VertexPositions& positions,
                         const Bodies& bodies);

}  // namespace ribbon

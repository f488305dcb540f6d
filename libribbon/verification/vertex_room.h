// How much room is there around each vertex?
#pragma once

#include <vector>

#include "verification/box_tree.h"
#include "verification/feature_owners.h"
#include "verification/triangle_soup.h"

namespace ribbon {

// For each point of the soup a distance, at most `reach_m`: no vertex, edge or triangle that has
// the point comes nearer to a feature that shares no vertex with it, where one of both is judged.
// Rigorous as smallest_gap() is.
//
// So if no point moves by half of its distance, nothing meets that shares no vertex: on the way,
// two features of a pair approach each other by less than the distance between them.
std::vector<double> vertex_room(const TriangleSoup& soup, const FeatureOwners& owners,
                                const BoxTree& judged, const BoxTree& rest, double reach_m);

}  // namespace ribbon

// Straightens a knotted polygon without passing it through itself.
#pragma once

#include <vector>

#include "exact/orientation.h"

namespace ribbon {

// A polygon from infinity to infinity: a direction, points, a direction. A knot that is closed far
// away.
using LongCurve = std::vector<ProjectivePoint>;

// Removes every vertex whose triangle with its two neighbours is met by no other edge, again and
// again (Koniaris and Muthukumar, "Self-entanglement in ring polymers", 1991; Taylor, "A deeply
// knotted protein structure", 2000). The tests are exact, and a vertex stays when a triangle is
// touched, so the knot is the same.
LongCurve simplified(LongCurve curve);

}  // namespace ribbon

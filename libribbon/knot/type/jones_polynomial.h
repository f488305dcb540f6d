// The Jones polynomial: an exact invariant that tells the usual knots and mirror images apart.
#pragma once

#include <optional>

#include "knot/type/knot_diagram.h"
#include "knot/type/laurent_polynomial.h"

namespace ribbon {

// In t, with 1 for the unknot and t + t^3 - t^4 for the right-handed trefoil (Jones 1985; by the
// state sum of Kauffman, "State models and the Jones polynomial", 1987). The cost grows with the
// number of strands that a line through the diagram must cut, not with all crossings. Nothing when
// the diagram is too tangled for that (more than 16 such strands may be) or a coefficient leaves 64
// bits.
std::optional<LaurentPolynomial> jones_polynomial(const KnotDiagram& diagram);

}  // namespace ribbon

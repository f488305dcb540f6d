// A second opinion on knots, from Regina.
#pragma once

#include <vector>

#include "knot/type/knot_diagram.h"
#include "knot/type/laurent_polynomial.h"

namespace ribbon {

// The Jones polynomial in t as Regina computes it. Its convention is ours: 1 for the unknot and
// t + t^3 - t^4 for the right-handed trefoil.
LaurentPolynomial regina_jones(const KnotDiagram& diagram);

// Of the knot with that Dowker-Thistlethwaite code, which does not tell its mirror image.
LaurentPolynomial regina_jones_of_code(const std::vector<int>& dowker_thistlethwaite);

}  // namespace ribbon

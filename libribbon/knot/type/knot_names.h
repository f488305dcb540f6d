// The names of the usual knots.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "knot/type/knot_diagram.h"
#include "knot/type/laurent_polynomial.h"

namespace ribbon {

// The knot that closes a braid: letter k crosses strands k and k + 1 right-handed, -k left-handed.
// Letters differ from 0, and the closed braid is one strand.
KnotDiagram braid_knot(const std::vector<int>& letters);

// "trefoil, right-handed (3 crossings)" for the Jones polynomial of that knot: the knots with up to
// 7 crossings and mirror images, some tied in practice, granny and reef knot. A knot is called
// right-handed if the crossings of its least diagram are so in the sum. Nothing for others.
std::optional<std::string> knot_name(const LaurentPolynomial& jones);

// All that knot_name() can return.
std::vector<std::string> all_knot_names();

// The name, or where there is none, "knot with Jones polynomial " and that.
std::string knot_text(const LaurentPolynomial& jones);

}  // namespace ribbon

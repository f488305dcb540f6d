// Knots as people tie and call them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "knot/type/knot_diagram.h"
#include "knot/type/laurent_polynomial.h"

namespace ribbon {

// What the knot of a drawing is called, all of them. Its closed type by the Jones polynomial:
// "reef knot"; "trefoil", "trefoil, left-handed" and "overhand knot". Forms that are slipped close
// to a simpler knot, so they are told by the drawing itself, whichever way round it is walked, seen
// or mirrored: "bow". Only the types that can be told are in it: of a drawing that is not
// is_planar(), none.
std::vector<std::string> knot_names(const KnotDiagram& drawing);

// Those of the closed type alone: "reef knot" and "square knot". None where it is not a usual knot.
std::vector<std::string> names_of_type(const LaurentPolynomial& jones);

// The form alone: "bow".
std::optional<std::string_view> tied_form(const KnotDiagram& drawing);

// All that knot_names() can return, and all that names_of_type() can.
const std::vector<std::string>& known_knot_names();
const std::vector<std::string>& known_type_names();

// The signed Gauss code of a drawing as "O1+ U2- O2- U1+": over or under, crossings numbered as
// they are met, signs.
std::string gauss_code(const KnotDiagram& drawing);

}  // namespace ribbon

// Is what was drawn the knot that was meant, and what is simulated the knot that was drawn?
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "curve/over_under.h"
#include "knot/type/knot_diagram.h"
#include "knot/type/laurent_polynomial.h"
#include "result/result.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"

namespace ribbon {

KnotDiagram diagram_of(const std::vector<Crossing>& crossings);

// The Jones polynomial; nothing where an end of the drawing lies inside a loop, or where it is too
// tangled.
std::optional<LaurentPolynomial> closed_type(const KnotDiagram& drawing);

// "bow, closes to trefoil, left-handed (3 crossings)": what it is called as it is tied, and its
// closed type, as far as they can be told.
std::string text_of_knot(const KnotDiagram& drawing);

// Fails, with the place in the scene, where the scene expects a knot of another name than any that
// the drawing has; says then what it ties, and which list of crossings would tie what is expected,
// if changing one to three of them does. So it does where no knot has that name.
// Likewise of the part whose knot is expected by itself. Marks have been found.
Result<void> check_expected_knot(const Scene& scene, const RibbonMesh& drawn);

// Fails where the ribbon that begins (3 x particles), closed where that is clearest or towards the
// viewer, is another closed type than its drawing, or the part of it whose knot is certified by
// itself, closed where that is clearest. Either may be unknown.
Result<void> check_first_frame(const Scene& scene, const RibbonMesh& drawn,
                               const Eigen::Matrix3Xd& start);

// Of the band's length. Marks have been found.
std::array<double, 2> shares_of(const BandPart& part);

}  // namespace ribbon

// The drawing as a knot diagram to look at.
#pragma once

#include <string>
#include <vector>

#include "curve/drawing.h"
#include "curve/object_passages.h"
#include "curve/over_under.h"

namespace ribbon {

// An SVG file of the drawing: a group 'band' of pieces with a gap at every passage under, dashed
// and of class "behind" or of class "front" where they pass the object, which read_drawing() reads
// back, and the number of each passage before the crossing or where it comes over the object, on
// the left of its strand. Where passages are close, gaps and numbers are small.
std::string diagram_svg(const Drawing& drawing, const std::vector<Passage>& passages,
                        const std::vector<ObjectPassage>& objects);

}  // namespace ribbon

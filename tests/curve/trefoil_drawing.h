// A drawing whose crossings can be counted by hand.
#pragma once

#include "curve/drawing.h"

namespace ribbon {

// Two strands wound round each other from left to right; the first comes back below to become the
// second. Along each strand the crossings are 2 sqrt(2) units apart. Seen on the screen the first
// goes down at (1, 0), the second up: over first makes it right-handed.
inline const Drawing trefoil_drawing = {{0, -1}, {2, 1}, {4, -1}, {6, 1}, {6, 4},
                                        {0, 4},  {0, 1}, {2, -1}, {4, 1}, {6, -1}};

}  // namespace ribbon

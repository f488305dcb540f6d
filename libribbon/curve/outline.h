// A ribbon's width read off its drawn outline.
#pragma once

#include "curve/drawing.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// The width, in drawing units, at evenly spaced shares of the long axis of a closed line, as few of
// them as give that of all others to within a thousandth of the widest. It begins at the left end,
// that of an upright outline at the upper one. Fails, with the place in the drawing, where the line
// is not longer than wide, crosses itself, doubles back, or is not symmetric about its axis.
Result<WidthProfile> widths_of(const Drawing& outline);

// The scene, also its text, with the widths in place of its outline: so a run can go on without the
// drawing. One unit of that is one of the curve. Fails, with the place, where there is no such path
// and where it is no outline of a band.
Result<Scene> with_outline_read(const Scene& scene);

}  // namespace ribbon

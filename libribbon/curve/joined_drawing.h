// A drawing that is one line, with gaps where it passes under itself, as in knot diagrams.
#pragma once

#include <cstddef>
#include <vector>

#include "curve/drawing.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// A part of the walk that is drawn in front of the object or behind it.
struct DepthPart {
  std::size_t begin = 0;  // points
  std::size_t end = 0;
  Depth depth = Depth::untold;
};

struct JoinedDrawing {
  Drawing points;
  std::vector<std::size_t> gaps;       // segments that were not drawn, in the order of the walk
  std::vector<DepthPart> depths = {};  // likewise; a part goes on over gaps in it
};

// A stroke of the drawing.
struct DrawnPiece {
  Drawing points;
  Depth depth = Depth::untold;
};

// Pieces that were drawn, one after the other: across each gap, the nearest ends that continue one
// another (both turn by less than 30 degrees, no further apart than a tenth of the drawing's
// diagonal); where ends meet there is none. It begins at the first free end. Fails, with the place,
// where more than two ends are free or some pieces close to a loop. At least one piece.
Result<JoinedDrawing> joined(const std::vector<DrawnPiece>& pieces);

// What the scene's curve draws. Fails, with the place, where it is not one line.
Result<JoinedDrawing> read_drawing(const CurveScene& scene);

// A path that is not to become a ribbon, which another key of the scene names, flattened to within
// a thousandth of its extent. Fails as above.
Result<Drawing> read_path(const DrawnSvg& drawn, const PathKey& key);

}  // namespace ribbon

// A knot as a drawing: which strand passes over which, in the order in which one meets them.
#pragma once

#include <optional>
#include <vector>

#include "knot/type/simplify_curve.h"

namespace ribbon {

// The signed Gauss code of a long knot. Every crossing is passed twice, once over and once under.
struct KnotDiagram {
  struct Pass {
    int crossing = 0;
    bool over = false;
  };
  std::vector<Pass> passes;  // from one end to the other
  std::vector<int> signs;    // of each crossing: 1 right-handed, -1 left-handed

  [[nodiscard]] int crossing_count() const { return static_cast<int>(signs.size()); }
  // The sum of the signs.
  [[nodiscard]] int writhe() const;
};

// Can it be drawn without further crossings so that both ends lead out? Not, for instance, where an
// end lies inside a loop. Only then is the knot of the diagram that of the curve.
bool is_planar(const KnotDiagram& diagram);

// The curve as seen from the direction `view`. Nothing when that view is not in general position.
std::optional<KnotDiagram> diagram(const LongCurve& curve, const ProjectivePoint& view);

// The same knot without the loops and the pairs of crossings that the first and the second
// Reidemeister move take away.
KnotDiagram reduced(KnotDiagram diagram);

// A diagram of the curve with few crossings, reduced: the best of several views. Nothing if none
// is in general position, which happens only to a curve that meets itself.
std::optional<KnotDiagram> simple_diagram(const LongCurve& curve);

}  // namespace ribbon

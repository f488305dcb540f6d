// Which rows of a ribbon a hand has.
#pragma once

#include <cmath>

#include "geometry/ribbon_grid.h"
#include "scene/stage_scene.h"

namespace ribbon {

// Some rows after one another; at least one.
struct HeldRows {
  int first = 0;
  int last = 0;

  [[nodiscard]] int count() const { return last - first + 1; }
};

// Those nearest to where the span begins and ends.
inline HeldRows held_rows(const Span& span, const RibbonGrid& grid) {
  const auto row = [&grid](double share) {
    return static_cast<int>(std::lround(share * (grid.along - 1)));
  };
  return {row(span.begin), row(span.end)};
}

}  // namespace ribbon

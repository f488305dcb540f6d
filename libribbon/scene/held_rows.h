// Which rows of a ribbon the hands of a stage have.
#pragma once

#include <span>
#include <vector>

#include "scene/stage_scene.h"

namespace ribbon {

// Some rows after one another.
struct HeldRows {
  int first = 0;
  int last = 0;

  [[nodiscard]] int count() const { return last - first + 1; }
};

// Of each span, of a ribbon of `along` rows: from the row nearest to its begin to the one nearest
// to its end. Spans do not overlap, and no row is in two: the one in which a span ends and another
// begins is the latter's, unless it was the former's only one. A span for which none is left has a
// count below 1. In whatever order they are given, each has the same rows.
std::vector<HeldRows> held_rows(std::span<const Span> spans, int along);

}  // namespace ribbon

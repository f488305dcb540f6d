#include "knot/ribbon_part.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ribbon {

std::optional<RibbonPart> part_between(const RibbonGrid& grid, double one, double other) {
  assert(0 <= one && one <= 1 && 0 <= other && other <= 1);
  const auto row = [&grid](double share) {
    return static_cast<int>(std::lround(share * (grid.along - 1)));
  };
  const int first = row(std::min(one, other));
  const int last = row(std::max(one, other));
  return first < last ? std::optional(RibbonPart{first / 2 * 2, last}) : std::nullopt;
}

}  // namespace ribbon

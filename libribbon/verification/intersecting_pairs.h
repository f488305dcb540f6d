// Which triangles of a soup meet?
#pragma once

#include <cstddef>
#include <vector>

#include "verification/box_tree.h"
#include "verification/triangle_soup.h"

namespace ribbon {

struct IntersectingPairs {
  std::vector<TrianglePair> pairs;  // ascending
  bool all = true;                  // false: the search ended early, there may be more
};

// The pairs that meet as triangles_meet says, of a judged triangle and any other. `judged` and
// `rest` are trees of the soup's judged triangles and of the rest. The search ends once `most`
// pairs are found, so that cloth that collapsed into a point does not take for ever.
IntersectingPairs intersecting_pairs(const TriangleSoup& soup, const BoxTree& judged,
                                     const BoxTree& rest, std::size_t most);

}  // namespace ribbon

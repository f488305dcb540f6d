// Which edges' strain is measured where nobody has said it.
#pragma once

#include "geometry/limited_edges.h"

namespace ribbon::python {

inline constexpr LimitedEdges all_edges{.along = true, .across = true, .diagonals = true};

}  // namespace ribbon::python

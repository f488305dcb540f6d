// The paper's other scheme (section 5.4.3): space is divided into cells, and only what shares a
// cell is tested.
#pragma once

#include <span>
#include <vector>

#include "geometry/box.h"
#include "simulation/detection/triangle_bvh.h"

namespace ribbon {

// The pairs of boxes that meet, each once. Cells are cubes of cell_m. Only cells that hold
// something take memory: they are found through a table of as many slots as there are entries.
std::vector<CandidatePair> pairs_by_cells(std::span<const Box> boxes, double cell_m);

}  // namespace ribbon

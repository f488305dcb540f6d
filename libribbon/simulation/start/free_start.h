// A start that is certainly free of intersections (paper, section 7: ribbons too wide for their
// drawing).
#pragma once

#include <string_view>

#include "result/result.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"
#include "simulation/detection/bodies.h"
#include "simulation/state/cloth.h"
#include "simulation/step/deformation.h"

namespace ribbon {

// How a ribbon came to its start.
enum class StartKind {
  free,       // as generated, it intersected nothing
  grown,      // from a thin band that was free, its width raised through the gate
  recovered,  // schemes A, B and C moved it out of what it pierced
};

// "free", "grown" or "recovered".
std::string_view word_for(StartKind kind);

struct StartReport {
  StartKind kind = StartKind::free;
  int recovery_iterations = 0;  // how often a scheme was applied
  int penetrating_edges = 0;    // left; none with the gate
};

// Moves the cloth from where it was generated to a start that is free, settled and at rest,
// nothing closer than the gate's hard gap. Where it intersects nothing it is taken as generated.
// Otherwise its rows are narrowed about their centres until the thin band is free, and its natural
// width is raised step by step (grow_width): all motion passes the gate, so the band stays free,
// and it folds and waves where it has no room. Where no thin band is free, schemes A, B and C move
// one out of what it pierces first.
//
// scene.contact must be the gate; `deformation` is of the whole width. cloth.positions: the ribbon
// as generated, then the obstacle. Fails, saying where on the ribbon and what to change, where even
// a thin band stays pierced and where the ribbon finds no room for its width. The cloth then lies
// anywhere.
Result<StartReport> find_free_start(const Scene& scene, const RibbonMesh& ribbon, Bodies& bodies,
                                    Deformation& deformation, Cloth& cloth);

}  // namespace ribbon

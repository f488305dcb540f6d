// A start that is certainly free of intersections (paper, section 7: ribbons too wide for their
// drawing).
#pragma once

#include "result/result.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/detection/bodies.h"
#include "simulation/start/start_report.h"
#include "simulation/state/cloth.h"

namespace ribbon {

// Moves the cloth from where it was generated to a start that is free, settled, at rest, nothing
// closer than the minimum separation, and relaxed (dynamic_relaxation.h) unless that would fail the
// test: short ends slip out of a wide ribbon that lets go of its strain. Where it intersects
// nothing it is taken as generated. Otherwise its rows are narrowed about their centres until the
// thin band is free, and its rest width is raised step by step (grow_width): all motion passes the
// gate, so the band stays free, and it folds and waves where it has no room. Where no thin band is
// free, schemes A, B and C move one out of what it pierces first.
//
// scene.contact must be the gate; `lengths` are of the whole width. Fails, saying where on the
// ribbon and what to change, where even a thin band stays pierced and where the ribbon finds no
// room for its width. The cloth then lies anywhere.
Result<StartReport> find_free_start(const Scene& scene, const RibbonMesh& ribbon,
                                    const ContactLengths& lengths, const StartObserver& observer,
                                    const StartTest& test, Bodies& bodies, Cloth& cloth);

}  // namespace ribbon

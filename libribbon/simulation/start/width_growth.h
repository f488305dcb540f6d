// Raising the width of a band step by step (paper, section 7).
#pragma once

#include <Eigen/Core>

#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"
#include "simulation/detection/bodies.h"
#include "simulation/start/start_report.h"
#include "simulation/state/cloth.h"

namespace ribbon {

// `positions` (3 x particles) with every row of the ribbon scaled about its centre.
Eigen::Matrix3Xd rows_scaled(const RibbonGrid& grid, double scale,
                             const Eigen::Matrix3Xd& positions);

struct GrowthReport {
  bool complete = false;        // the band has all of its width
  double settled_fraction = 0;  // the largest fraction of it at which the band settled
  int strained_particle = 0;    // at the edge that is strained most
  int steps = 0;                // taken, at all widths
};

// Raises the rest width of the band, which lies free at a fraction of it, to all of it, by 5 % at a
// time. Each time the rows are scaled up likewise, as far as contact lets; then the band takes
// steps without force, at rest before each, until it has settled: until at most 1 % of its edges,
// along and across, are off their rest length by more than 10 %. At its full width it goes on,
// within the same number of steps, until none is. Ends early where it does not settle: it has no
// room, its worst edge stays torn for some steps, or the observer, whom each step asks, gives it
// up. All motion passes the contact of the scene, which must be the gate.
GrowthReport grow_width(const Scene& scene, const RibbonMesh& ribbon, double fraction,
                        const StartObserver& observer, Bodies& bodies, Cloth& cloth);

}  // namespace ribbon

// What the steps of a scene cost in time and memory.
#pragma once

#include <array>
#include <optional>

#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"
#include "simulation/step/step_clock.h"

namespace ribbon {

// Means of the measured steps; bytes are the solver's alone, without scene, mesh and obstacle file.
struct StepCost {
  double processor_s = 0;                          // of all threads
  double wall_s = 0;                               // by a clock
  std::array<double, step_phase_count> phase_s{};  // by a clock, by phase
  double allocations = 0;
  double held_bytes = 0;    // after the steps
  double most_bytes = 0;    // at any time in the steps
  double start_bytes = 0;   // at any time while the start was looked for
  double listed_pairs = 0;  // of features, by all detections
  double sweeps = 0;        // of the strain correction
};

// Of `steps` steps, after `steps_before` that are not measured. Fails as the processor does.
Result<StepCost> step_cost(const Scene& scene, const RibbonMesh& mesh,
                           const std::optional<TriangleMesh>& obstacle, int steps_before,
                           int steps);

}  // namespace ribbon

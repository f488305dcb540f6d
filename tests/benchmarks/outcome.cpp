#include "benchmarks/outcome.h"

#include <algorithm>
#include <chrono>

#include "benchmarks/solver/energy_account.h"
#include "simulation/fastening_processor.h"
#include "simulation/state/edge_strain.h"
#include "verification/frame_verifier.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

// Large ribbons are judged at every tenth step.
bool is_judged(const ExtremeScene& extreme, int step) {
  return extreme.mesh.grid.particle_count() < 10'000 || step % 10 == 0 || step == extreme.steps;
}

Outcome run(const ExtremeScene& extreme, int steps, FasteningProcessor& fastening) {
  using Clock = std::chrono::steady_clock;
  const FrameVerifier verifier(extreme.mesh.size(), extreme.obstacle);
  // What the strain limit cares for, whether there are springs or not.
  const SpringNetwork limited =
      spring_network({extreme.mesh.grid, extreme.mesh.length_m, extreme.mesh.width_m},
                     {.stretch = 1, .shear = extreme.scene.springs.shear});
  Matrix3Xd before = fastening.positions();
  EnergyAccount account(extreme.scene, extreme.mesh, before);
  Outcome outcome;
  for (int step = 1; step <= steps; ++step) {
    const auto start = Clock::now();
    fastening.step();
    outcome.time_s += std::chrono::duration<double>(Clock::now() - start).count();
    const Matrix3Xd after = fastening.positions();
    outcome.steps = step;
    outcome.is_finite = after.allFinite();
    if (!outcome.is_finite) break;
    outcome.last_strain = worst_strain(limited, after);
    outcome.worst_strain = std::max(outcome.worst_strain, outcome.last_strain);
    account.add_step(before, after);
    if (is_judged(extreme, step))
      outcome.intersecting_pairs =
          std::max(outcome.intersecting_pairs,
                   verifier.verify(after.cast<float>()).intersections.pairs.size());
    before = after;
  }
  outcome.energy = account.most();
  outcome.is_explosion = account.is_explosion();
  outcome.time_s /= std::max(1, outcome.steps);
  return outcome;
}

}  // namespace

Outcome outcome_of(const ExtremeScene& extreme, int most_steps) {
  auto fastening = FasteningProcessor::create(extreme.scene, extreme.mesh, extreme.obstacle);
  if (fastening) return run(extreme, std::min(most_steps, extreme.steps), *fastening);
  Outcome outcome;
  outcome.refusal = fastening.error().sentence();
  return outcome;
}

}  // namespace ribbon

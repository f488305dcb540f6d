#include "benchmarks/accuracy/accuracy_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "benchmarks/sample_ribbon.h"
#include "benchmarks/solver/energy_account.h"
#include "simulation/fastening_processor.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double sampling_s = 0.2;

Ends ends_of(const RibbonGrid& grid, const Matrix3Xd& positions) {
  Ends ends;
  ends.col(0) = positions.leftCols(grid.across).rowwise().mean();
  ends.col(1) = positions.rightCols(grid.across).rowwise().mean();
  return ends;
}

double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void step_once(FasteningProcessor& fastening, EnergyAccount& account, AccuracyRun& run) {
  const Matrix3Xd before = std::move(run.last);
  const double begun_s = processor_s();
  fastening.step();
  run.processor_s += processor_s() - begun_s;
  run.last = fastening.positions();
  run.worst_strain = std::max(run.worst_strain, fastening.strain());
  account.add_step(before, run.last);
  if (!run.tight_s && fastening.is_tight()) run.tight_s = fastening.time_s();
}

AccuracyRun run(const Scene& scene, const RibbonMesh& mesh, double duration_s,
                FasteningProcessor& fastening) {
  AccuracyRun run;
  run.start = fastening.positions();
  run.last = run.start;
  EnergyAccount account(scene, mesh, run.start);
  const long steps = std::lround(duration_s / scene.time.step_s);
  const long steps_per_sample = std::lround(sampling_s / scene.time.step_s);
  for (long step = 1; step <= steps; ++step) {
    step_once(fastening, account, run);
    if (step % steps_per_sample == 0) run.ends.push_back(ends_of(mesh.grid, run.last));
  }
  run.simulated_s = fastening.time_s();
  const Tightness tightness = fastening.tightness().value();
  run.rope_length = tightness.rope_length;
  run.contact_share = tightness.contact_share;
  run.energy = account.most();
  return run;
}

}  // namespace

Result<AccuracyRun> run_by(const AccuracySetting& setting, Scene scene, double duration_s) {
  set_accuracy(setting.numbers, scene);
  const auto ribbon = ribbon_of(scene);
  if (!ribbon) return tl::unexpected(ribbon.error());
  auto fastening = FasteningProcessor::create(scene, ribbon->mesh, ribbon->obstacle);
  if (!fastening) return tl::unexpected(fastening.error());
  return run(scene, ribbon->mesh, duration_s, *fastening);
}

}  // namespace ribbon

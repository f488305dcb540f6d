#include "benchmarks/solver/step_cost.h"

#include <chrono>
#include <ctime>

#include "benchmarks/heap_use.h"
#include "simulation/fastening_processor.h"

namespace ribbon {

namespace {

using benchmark::heap_use;
using benchmark::restart_heap_use;

// std::clock would overflow its microseconds only after hours, but rounds to them.
double processor_time_s() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double since(std::size_t bytes_before, std::size_t bytes) {
  return static_cast<double>(bytes) - static_cast<double>(bytes_before);
}

void run_measured(int steps, FasteningProcessor& fastening, StepCost& cost) {
  using Clock = std::chrono::steady_clock;
  const PhaseSums before = fastening.phase_sums();
  const double processor_s = processor_time_s();
  const auto start = Clock::now();
  for (int step = 0; step < steps; ++step) fastening.step();
  cost.wall_s = std::chrono::duration<double>(Clock::now() - start).count() / steps;
  cost.processor_s = (processor_time_s() - processor_s) / steps;
  const PhaseSums& after = fastening.phase_sums();
  for (std::size_t phase = 0; phase < step_phase_count; ++phase)
    cost.phase_s[phase] = (after.time_s[phase] - before.time_s[phase]) / steps;
  cost.listed_pairs = static_cast<double>(after.listed_pairs - before.listed_pairs) / steps;
  cost.sweeps = static_cast<double>(after.sweeps - before.sweeps) / steps;
}

}  // namespace

Result<StepCost> step_cost(const Scene& scene, const RibbonMesh& mesh,
                           const std::optional<TriangleMesh>& obstacle, int steps_before,
                           int steps) {
  StepCost cost;
  restart_heap_use();
  const std::size_t before = heap_use().bytes;
  auto fastening = FasteningProcessor::create(scene, mesh, obstacle);
  if (!fastening) return tl::unexpected(fastening.error());
  cost.start_bytes = since(before, heap_use().most_bytes);
  for (int step = 0; step < steps_before; ++step) fastening->step();
  restart_heap_use();
  run_measured(steps, *fastening, cost);
  const benchmark::HeapUse use = heap_use();
  cost.allocations = static_cast<double>(use.allocations) / steps;
  cost.held_bytes = since(before, use.bytes);
  cost.most_bytes = since(before, use.most_bytes);
  return cost;
}

}  // namespace ribbon

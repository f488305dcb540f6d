// benchmark_growth [--tight RECORDING] [--integrator NAME] [--step S] [--steps N] [--threads N]
// [--most-particles N] [--json FILE]: how time per step and memory grow from 8x400 to 64x3200
// particles. RECORDING: its last frame, refined by cubics, is where the tight ribbons begin;
// without it only loose ones are measured. Prints the table of docs/measured.md. Exit code 2 when
// something could not be read or written.
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/benchmark_main.h"
#include "benchmarks/measurement.h"
#include "benchmarks/sample_ribbon.h"
#include "benchmarks/solver/ribbon_states.h"
#include "benchmarks/solver/step_cost_json.h"
#include "parallel/parallel.h"

namespace ribbon {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string tight;
  std::optional<IntegrationMethod> integrator;
  std::optional<double> step_s;
  int steps = 20;
  int threads = 0;  // as many as there are cores
  int most_particles = 64 * 3200;
};

// The smallest is over before it can be measured.
constexpr auto sizes = std::span(ribbon_sizes).subspan<1>();

void describe(CLI::App& app, Options& options) {
  app.add_option("--tight", options.tight, "the recording whose last frame is refined")
      ->type_name("RECORDING");
  app.add_option("--integrator", options.integrator, "instead of the sample's")
      ->transform(CLI::CheckedTransformer(std::map<std::string, IntegrationMethod>(
          integration_methods.begin(), integration_methods.end())))
      ->option_text("rk4, symplectic_euler or implicit");
  app.add_option("--step", options.step_s, "seconds, instead of the sample's")
      ->check(CLI::PositiveNumber);
  app.add_option("--steps", options.steps, "that are measured")->check(CLI::Range(1, 1'000'000));
  app.add_option("--threads", options.threads, "0: all cores")->check(CLI::Range(0, 1024));
  app.add_option("--most-particles", options.most_particles, "no larger ribbons");
}

// The sample's ribbon, loose as drawn, or tight.
Result<SampleRibbon> ribbon_in(const std::string& tight, const RibbonSize& size,
                               const Options& options) {
  auto ribbon =
      sample_ribbon(RIBBON_SAMPLES "/overhand-hourglass-8x400.toml", size.along, size.across);
  if (!ribbon) return ribbon;
  if (options.integrator) ribbon->scene.time.integrator = *options.integrator;
  if (options.step_s) ribbon->scene.time.step_s = *options.step_s;
  ribbon->scene.recording.max_position_error = 1e-6;  // short edges bear no more
  if (tight.empty()) return ribbon;
  auto motion = tight_ribbon(tight, size.along, size.across);
  if (!motion) return tl::unexpected(motion.error());
  ribbon->mesh.positions = std::move(motion->t0);
  return ribbon;
}

void print_heading(const std::string& state) {
  std::printf("\n%s\n\n| particles | ms a step | by the clock |", state.c_str());
  for (std::size_t phase = 0; phase < step_phase_count; ++phase)
    std::printf(" %s |", std::string(word_for(static_cast<StepPhase>(phase))).c_str());
  std::printf(" pairs | sweeps | start | held | at most |\n|---|---|---|");
  for (std::size_t phase = 0; phase < step_phase_count; ++phase) std::printf("---|");
  std::puts("---|---|---|---|---|");
}

void print(const RibbonSize& size, const StepCost& cost) {
  const double particles = size.particles();
  std::printf("| %dx%d | %.3g | %.3g |", size.across, size.along, 1e3 * cost.processor_s,
              1e3 * cost.wall_s);
  for (const double phase_s : cost.phase_s) std::printf(" %.0f %% |", 100 * phase_s / cost.wall_s);
  std::printf(" %.0f | %.1f | %.0f | %.0f | %.0f |\n", cost.listed_pairs, cost.sweeps,
              cost.start_bytes / particles, cost.held_bytes / particles,
              cost.most_bytes / particles);
  std::fflush(stdout);
}

Json json(const RibbonSize& size, const StepCost& cost) {
  Json json = {{"across", size.across}, {"along", size.along}};
  json.update(json_of(cost, size.particles()));
  return json;
}

// All sizes in one state: loose, or tight as in `tight`.
Result<Json> measure_state(const std::string& tight, const Options& options) {
  print_heading(tight.empty() ? "loose, as drawn" : "tight, from " + tight);
  Json state;
  std::vector<double> particles;
  std::vector<double> processor_s;
  std::vector<double> wall_s;
  for (const RibbonSize& size : sizes) {
    if (size.particles() > options.most_particles) break;
    const auto ribbon = ribbon_in(tight, size, options);
    if (!ribbon) return tl::unexpected(ribbon.error());
    const auto cost = step_cost(ribbon->scene, ribbon->mesh, ribbon->obstacle, 0, options.steps);
    if (!cost) {
      std::printf("| %dx%d | %s\n", size.across, size.along, cost.error().sentence().c_str());
      continue;
    }
    print(size, *cost);
    state["ribbons"].push_back(json(size, *cost));
    particles.push_back(size.particles());
    processor_s.push_back(cost->processor_s);
    wall_s.push_back(cost->wall_s);
  }
  if (particles.size() < 2) return state;
  state["exponent"] = benchmark::growth_exponent(particles, processor_s);
  state["exponent_by_the_clock"] = benchmark::growth_exponent(particles, wall_s);
  std::printf("\nExponent of the time against the particles: %.2f, by the clock %.2f\n",
              state["exponent"].get<double>(), state["exponent_by_the_clock"].get<double>());
  return state;
}

Result<Findings> run(const Options& options) {
  set_thread_limit(options.threads);
  Json report;
  std::vector<std::string> states = {""};
  if (!options.tight.empty()) states.push_back(options.tight);
  for (const std::string& tight : states) {
    auto state = measure_state(tight, options);
    if (!state) return tl::unexpected(state.error());
    report[tight.empty() ? "loose" : "tight"] = std::move(*state);
  }
  return Findings{std::move(report)};
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>("benchmark_growth", argc, argv, ribbon::describe,
                                                 ribbon::run);
}

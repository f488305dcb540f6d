// benchmark_growth [--tight RECORDING] [--integrator NAME] [--step S] [--steps N] [--threads N]
// [--most-particles N] [--json FILE]: how time per step and memory grow from 8x400 to 64x3200
// particles. RECORDING: its last frame, refined by cubics, is where the tight ribbons begin;
// without it only loose ones are measured. Prints the table of docs/simulation.md. Exit code 2 when
// something could not be read or written.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/measurement.h"
#include "benchmarks/ribbon_states.h"
#include "benchmarks/sample_ribbon.h"
#include "benchmarks/step_cost_json.h"
#include "commandline/tool.h"
#include "files/files.h"
#include "parallel/parallel.h"

namespace ribbon {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string tight;
  std::string json;
  std::optional<IntegrationMethod> integrator;
  std::optional<double> step_s;
  int steps = 20;
  int threads = 0;  // as many as there are cores
  int most_particles = 64 * 3200;
};

struct Size {
  int across;
  int along;

  [[nodiscard]] int particles() const { return across * along; }
};
constexpr std::array<Size, 7> sizes = {
    {{8, 400}, {16, 400}, {16, 800}, {32, 800}, {32, 1600}, {64, 1600}, {64, 3200}}};

constexpr std::array<std::pair<const char*, IntegrationMethod>, 3> integrators = {
    {{"rk4", IntegrationMethod::rk4},
     {"symplectic_euler", IntegrationMethod::symplectic_euler},
     {"implicit", IntegrationMethod::implicit}}};

bool set(const std::string& name, const std::string& value, Options& options) {
  if (name == "--tight") options.tight = value;
  if (name == "--json") options.json = value;
  if (name == "--steps") options.steps = std::atoi(value.c_str());
  if (name == "--step") options.step_s = std::atof(value.c_str());
  if (name == "--threads") options.threads = std::atoi(value.c_str());
  if (name == "--most-particles") options.most_particles = std::atoi(value.c_str());
  for (const auto& [word, method] : integrators)
    if (name == "--integrator" && value == word) options.integrator = method;
  constexpr std::array<const char*, 6> known = {"--tight", "--json",    "--steps",
                                                "--step",  "--threads", "--most-particles"};
  return name == "--integrator" ? options.integrator.has_value()
                                : std::find(known.begin(), known.end(), name) != known.end();
}

Result<Options> parse(std::span<char*> arguments) {
  Options options;
  std::size_t i = 0;
  while (i + 1 < arguments.size() && set(arguments[i], arguments[i + 1], options)) i += 2;
  if (i < arguments.size())
    return failure(
        "", "'" + std::string(arguments[i]) + "' is not understood",
        "write --tight RECORDING, --integrator rk4, symplectic_euler or implicit, --step "
        "S, --steps N, --threads N, --most-particles N or --json FILE");
  if (options.steps < 1) return failure("", "no step would be measured", "write --steps 1 or more");
  return options;
}

// The sample's ribbon, loose as drawn, or tight.
Result<SampleRibbon> ribbon_in(const std::string& tight, const Size& size, const Options& options) {
  auto ribbon =
      sample_ribbon(RIBBON_SAMPLES "/overhand-hourglass-8x400.toml", size.along, size.across);
  if (!ribbon) return ribbon;
  if (options.integrator) ribbon->scene.time.integrator = *options.integrator;
  if (options.step_s) ribbon->scene.time.step_s = *options.step_s;
  if (tight.empty()) return ribbon;
  auto motion = tight_ribbon(tight, size.along, size.across);
  if (!motion) return tl::unexpected(motion.error());
  ribbon->mesh.positions = std::move(motion->t0);
  return ribbon;
}

void print_heading(const std::string& state) {
  std::printf("\n%s\n\n| particles | ms a step | by the clock |", state.c_str());
  for (std::size_t stage = 0; stage < stage_count; ++stage)
    std::printf(" %s |", std::string(word_for(static_cast<Stage>(stage))).c_str());
  std::printf(" pairs | sweeps | start | held | at most |\n|---|---|---|");
  for (std::size_t stage = 0; stage < stage_count; ++stage) std::printf("---|");
  std::puts("---|---|---|---|---|");
}

void print(const Size& size, const StepCost& cost) {
  const double particles = size.particles();
  std::printf("| %dx%d | %.3g | %.3g |", size.across, size.along, 1e3 * cost.processor_s,
              1e3 * cost.wall_s);
  for (const double stage_s : cost.stage_s) std::printf(" %.0f %% |", 100 * stage_s / cost.wall_s);
  std::printf(" %.0f | %.1f | %.0f | %.0f | %.0f |\n", cost.listed_pairs, cost.sweeps,
              cost.start_bytes / particles, cost.held_bytes / particles,
              cost.most_bytes / particles);
  std::fflush(stdout);
}

Json json(const Size& size, const StepCost& cost) {
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
  for (const Size& size : sizes) {
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

Result<ExitCode> run(const Options& options) {
  set_thread_limit(options.threads);
  Json report;
  std::vector<std::string> states = {""};
  if (!options.tight.empty()) states.push_back(options.tight);
  for (const std::string& tight : states) {
    auto state = measure_state(tight, options);
    if (!state) return tl::unexpected(state.error());
    report[tight.empty() ? "loose" : "tight"] = std::move(*state);
  }
  if (!options.json.empty())
    if (auto written = write_file(options.json, report.dump(2) + "\n"); !written)
      return tl::unexpected(written.error());
  return ExitCode::done;
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("benchmark_growth", [&]() -> ribbon::Result<ribbon::ExitCode> {
    const auto options = ribbon::parse({argv + 1, static_cast<std::size_t>(argc - 1)});
    if (!options) return tl::unexpected(options.error());
    return ribbon::run(*options);
  });
}

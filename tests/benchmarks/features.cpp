// benchmark_features [--json FILE] [--scene FILE] [--across N] [--steps N] [--threads N]: what each
// feature of a scene costs, in time per step and memory per particle, on the loose ribbon of a
// sample. Prints the table of docs/simulation.md. Exit code 2 when something could not be read,
// simulated or written.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "benchmarks/feature_scenes.h"
#include "benchmarks/sample_ribbon.h"
#include "benchmarks/step_cost_json.h"
#include "commandline/tool.h"
#include "files/files.h"
#include "parallel/parallel.h"

namespace ribbon {
namespace {

using Json = nlohmann::ordered_json;

// By then the ribbon is in motion.
constexpr int steps_before = 20;

struct Options {
  std::string json;
  std::string scene = RIBBON_SAMPLES "/overhand-hourglass-8x400.toml";
  int across = 8;
  int steps = 40;
  int threads = 1;
};

Result<Options> parse(std::span<char*> arguments) {
  Options options;
  std::size_t i = 0;
  for (; i + 1 < arguments.size(); i += 2) {
    const std::string name = arguments[i];
    if (name == "--json")
      options.json = arguments[i + 1];
    else if (name == "--scene")
      options.scene = arguments[i + 1];
    else if (name == "--across")
      options.across = std::atoi(arguments[i + 1]);
    else if (name == "--steps")
      options.steps = std::atoi(arguments[i + 1]);
    else if (name == "--threads")
      options.threads = std::atoi(arguments[i + 1]);
    else
      break;
  }
  if (i < arguments.size())
    return failure("", "'" + std::string(arguments[i]) + "' is not understood",
                   "write --json FILE, --scene FILE, --across N, --steps N or --threads N");
  if (options.across < 2 || options.steps < 1)
    return failure("", "nothing would be simulated", "write --across 2 and --steps 1, or more");
  return options;
}

void print_heading() {
  std::string names = "| scene | ms a step |";
  std::string rule = "|---|---|";
  for (std::size_t stage = 0; stage < stage_count; ++stage) {
    names += " " + std::string(word_for(static_cast<Stage>(stage))) + " |";
    rule += "---|";
  }
  std::printf("%s held | at most | allocations |\n%s---|---|---|\n", names.c_str(), rule.c_str());
}

void print(const std::string& feature, const StepCost& cost, int particles) {
  std::printf("| %s | %.2f |", feature.c_str(), 1e3 * cost.processor_s);
  for (const double stage_s : cost.stage_s) std::printf(" %.0f %% |", 100 * stage_s / cost.wall_s);
  std::printf(" %.0f | %.0f | %.0f |\n", cost.held_bytes / particles, cost.most_bytes / particles,
              cost.allocations);
  std::fflush(stdout);
}

Result<ExitCode> run(const Options& options) {
  set_thread_limit(options.threads);
  auto full = read_scene(options.scene);
  if (!full) return tl::unexpected(full.error());
  const auto ribbon = sample_ribbon(options.scene, full->ribbon.along, options.across);
  if (!ribbon) return tl::unexpected(ribbon.error());
  const int particles = ribbon->mesh.grid.particle_count();
  Json report = Json::array();
  print_heading();
  for (const FeatureScene& feature : feature_scenes(ribbon->scene)) {
    const auto cost = step_cost(feature.scene, ribbon->mesh,
                                feature.scene.obstacle ? ribbon->obstacle : std::nullopt,
                                steps_before, options.steps);
    if (!cost) return tl::unexpected(cost.error());
    print(feature.feature, *cost, particles);
    report.push_back({{"scene", feature.feature}});
    report.back().update(json_of(*cost, particles));
  }
  if (!options.json.empty())
    if (auto written = write_file(options.json, report.dump(2) + "\n"); !written)
      return tl::unexpected(written.error());
  return ExitCode::done;
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("benchmark_features", [&]() -> ribbon::Result<ribbon::ExitCode> {
    const auto options = ribbon::parse({argv + 1, static_cast<std::size_t>(argc - 1)});
    if (!options) return tl::unexpected(options.error());
    return ribbon::run(*options);
  });
}

// benchmark_features [--json FILE] [--scene FILE] [--across N] [--steps N] [--threads N]: what each
// feature of a scene costs, in time per step and memory per particle, on the loose ribbon of a
// sample. Prints the table of docs/measured.md. Exit code 2 when something could not be read,
// simulated or written.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "benchmarks/benchmark_main.h"
#include "benchmarks/sample_ribbon.h"
#include "benchmarks/solver/feature_scenes.h"
#include "benchmarks/solver/step_cost_json.h"
#include "parallel/parallel.h"

namespace ribbon {
namespace {

using Json = nlohmann::ordered_json;

// By then the ribbon is in motion.
constexpr int steps_before = 20;

struct Options {
  std::string scene = RIBBON_SAMPLES "/overhand-hourglass-8x400.toml";
  int across = 8;
  int steps = 40;
  int threads = 1;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("--scene", options.scene, "whose ribbon and object are taken")->type_name("FILE");
  app.add_option("--across", options.across, "particles across")->check(CLI::Range(2, 500));
  app.add_option("--steps", options.steps, "that are measured")->check(CLI::Range(1, 1'000'000));
  app.add_option("--threads", options.threads, "0: all cores")->check(CLI::Range(0, 1024));
}

void print_heading() {
  std::string names = "| scene | ms a step |";
  std::string rule = "|---|---|";
  for (std::size_t phase = 0; phase < step_phase_count; ++phase) {
    names += " " + std::string(word_for(static_cast<StepPhase>(phase))) + " |";
    rule += "---|";
  }
  std::printf("%s held | at most | allocations |\n%s---|---|---|\n", names.c_str(), rule.c_str());
}

void print(const std::string& feature, const StepCost& cost, int particles) {
  std::printf("| %s | %.2f |", feature.c_str(), 1e3 * cost.processor_s);
  for (const double phase_s : cost.phase_s) std::printf(" %.0f %% |", 100 * phase_s / cost.wall_s);
  std::printf(" %.0f | %.0f | %.0f |\n", cost.held_bytes / particles, cost.most_bytes / particles,
              cost.allocations);
  std::fflush(stdout);
}

// As it is, or drawn with the widths of a feature that asks for others.
Result<SampleRibbon> with_feature(const SampleRibbon& ribbon, const Scene& scene) {
  if (scene.ribbon.profile) return ribbon_of(scene);
  return SampleRibbon{scene, ribbon.mesh, scene.obstacle ? ribbon.obstacle : std::nullopt};
}

Result<Findings> run(const Options& options) {
  set_thread_limit(options.threads);
  auto full = read_scene(options.scene);
  if (!full) return tl::unexpected(full.error());
  const auto ribbon = sample_ribbon(options.scene, full->ribbon.along, options.across);
  if (!ribbon) return tl::unexpected(ribbon.error());
  const int particles = ribbon->mesh.grid.particle_count();
  Json report = Json::array();
  print_heading();
  for (const FeatureScene& feature : feature_scenes(ribbon->scene)) {
    const auto drawn = with_feature(*ribbon, feature.scene);
    if (!drawn) return tl::unexpected(drawn.error());
    const auto cost =
        step_cost(drawn->scene, drawn->mesh, drawn->obstacle, steps_before, options.steps);
    if (!cost) return tl::unexpected(cost.error());
    print(feature.feature, *cost, particles);
    report.push_back({{"scene", feature.feature}});
    report.back().update(json_of(*cost, particles));
  }
  return Findings{std::move(report)};
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>("benchmark_features", argc, argv, ribbon::describe,
                                                 ribbon::run);
}

// benchmark_accuracy [--json FILE] [--starts N] [--seconds S] [--finest S] [--only TEXT]: what each
// level of accuracy and single settings around them cost, and how far they are from the converged
// fastening. Prints the table of docs/accuracy.md. Exit code 1 when a level is beaten in time and
// in accuracy, 2 when something could not be read or written.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/accuracy/accuracy_figures.h"
#include "benchmarks/accuracy/accuracy_run.h"
#include "benchmarks/accuracy/accuracy_settings.h"
#include "benchmarks/benchmark_main.h"
#include "files/files.h"
#include "parallel/parallel.h"
#include "soak/jitter.h"
#include "text/number_text.h"

namespace ribbon {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* sample = RIBBON_SAMPLES "/overhand-hourglass-8x400.toml";
constexpr double before_contact_s = 1;
constexpr double jitter_m = 1e-4;

struct Options {
  std::string only;  // the settings whose name holds this text
  int starts = 3;
  double seconds = 12;
  double finest_step_s = 0.000625;  // taken for converged
};

void describe(CLI::App& app, Options& options) {
  app.add_option("--only", options.only, "the settings whose name holds this")->type_name("TEXT");
  app.add_option("--starts", options.starts, "drawn by a trembling hand")
      ->check(CLI::Range(1, 1000));
  app.add_option("--seconds", options.seconds, "of each fastening")->check(CLI::Range(0.4, 1e6));
  app.add_option("--finest", options.finest_step_s, "the step taken for converged, seconds")
      ->check(CLI::Range(1e-6, 0.01));
}

// The sample with its drawing moved here and there by less than a tenth of a millimetre, which
// nobody would see. A quarter of its particles, as stiff in all.
Result<Scene> jittered_sample(int seed) {
  const auto text = jittered_scene(sample, static_cast<std::uint64_t>(seed), jitter_m);
  if (!text) return tl::unexpected(text.error());
  const auto file = std::filesystem::temp_directory_path() / "jittered-sample.toml";
  if (auto written = write_file(file, *text); !written) return tl::unexpected(written.error());
  auto scene = read_scene(file);
  std::filesystem::remove(file);
  const auto original = read_scene(sample);
  if (!scene || !original) return scene ? original : scene;
  scene->obstacle = original->obstacle;
  scene->ribbon.along /= 2;
  scene->ribbon.across /= 2;
  return scene;
}

// A band as long and as stiff as the sample's, laid in a wide arc round the axis and pulled
// straight, touches nothing.
DrawnPoints wide_arc() {
  constexpr double radius_mm = 900;
  constexpr double half_angle = 2.5;
  DrawnPoints drawn;
  for (int i = 0; i <= 100; ++i) {
    const double angle = half_angle * (i / 50.0 - 1);
    drawn.points.emplace_back(radius_mm * std::sin(angle), radius_mm * std::cos(angle));
  }
  return drawn;
}

Result<AccuracyRun> run_before_contact(const AccuracySetting& setting) {
  auto scene = read_scene(sample);
  if (!scene) return tl::unexpected(scene.error());
  scene->obstacle.reset();
  scene->curve.drawing = wide_arc();
  return run_by(setting, *scene, before_contact_s);
}

Result<AccuracyRuns> runs_by(const AccuracySetting& setting, const Options& options) {
  AccuracyRuns runs;
  auto before = run_before_contact(setting);
  if (!before) return tl::unexpected(before.error());
  runs.before_contact = std::move(*before);
  for (int seed = 1; seed <= options.starts; ++seed) {
    const auto scene = jittered_sample(seed);
    if (!scene) return tl::unexpected(scene.error());
    auto run = run_by(setting, *scene, options.seconds);
    if (!run) return tl::unexpected(run.error());
    runs.fastenings.push_back(std::move(*run));
  }
  return runs;
}

std::string with_spread(const Measured& measured, int digits) {
  return decimals(measured.mean, digits) + " ± " + decimals(measured.spread, digits);
}

Measured in_percent(const Measured& share) {
  return {100 * share.mean, 100 * share.spread};
}

void print_heading() {
  std::puts(
      "| setting | processor time, s / s | before contact | after contact | tight after, s | rope "
      "length | ends apart, m | worst strain | energy |\n|---|---|---|---|---|---|---|---|---|");
}

void print(const AccuracyFigures& figures) {
  std::printf("| %s | %.3g | %.2g %% | %s %% | %s | %s | %s | %.1f %% | %.2f |\n",
              figures.name.c_str(), figures.processor_s, 100 * figures.before_contact,
              with_spread(in_percent(figures.after_contact), 2).c_str(),
              with_spread(figures.tight_s, 2).c_str(), with_spread(figures.rope_length, 2).c_str(),
              with_spread(figures.ends_apart_m, 4).c_str(), 100 * figures.worst_strain,
              figures.energy);
  std::fflush(stdout);
}

Json json(const Measured& measured) {
  return {{"mean", measured.mean}, {"spread", measured.spread}};
}

Json json(const AccuracyFigures& figures) {
  return {{"name", figures.name},
          {"level", figures.is_level},
          {"processor_s", figures.processor_s},
          {"before_contact", figures.before_contact},
          {"after_contact", json(figures.after_contact)},
          {"tight_s", json(figures.tight_s)},
          {"rope_length", json(figures.rope_length)},
          {"ends_apart_m", json(figures.ends_apart_m)},
          {"worst_strain", figures.worst_strain},
          {"energy", figures.energy}};
}

// Tells which level is beaten by what, and whether any is.
bool tell_beaten(const std::vector<AccuracyFigures>& all) {
  bool any = false;
  for (const AccuracyFigures& level : all)
    for (const AccuracyFigures& other : all)
      if (level.is_level && beats(other, level)) {
        std::printf("%s is beaten by %s\n", level.name.c_str(), other.name.c_str());
        any = true;
      }
  return any;
}

// Ends are compared at every fifth of a second, which has to be a step by any setting.
void fit_to_fifths(Options& options) {
  options.seconds = 0.2 * std::round(5 * options.seconds);
  options.finest_step_s = 0.01 / std::round(0.01 / options.finest_step_s);
}

Result<Findings> run(Options options) {
  fit_to_fifths(options);
  set_thread_limit(1);
  std::vector<AccuracySetting> settings = {converged_setting(options.finest_step_s)};
  for (AccuracySetting& setting : compared_settings())
    if (setting.name.find(options.only) != std::string::npos)
      settings.push_back(std::move(setting));
  print_heading();
  std::vector<AccuracyFigures> all;
  AccuracyRuns converged;
  for (const AccuracySetting& setting : settings) {
    auto runs = runs_by(setting, options);
    if (!runs) {
      std::printf("| %s | %s |\n", setting.name.c_str(), runs.error().sentence().c_str());
      continue;
    }
    if (all.empty()) converged = *runs;
    all.push_back(figures_of(setting, *runs, converged));
    print(all.back());
  }
  Json report = Json::array();
  for (const AccuracyFigures& figures : all) report.push_back(json(figures));
  const bool is_any_beaten = tell_beaten(all);
  return Findings{std::move(report), is_any_beaten ? ExitCode::answer_is_no : ExitCode::done};
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>("benchmark_accuracy", argc, argv, ribbon::describe,
                                                 ribbon::run);
}

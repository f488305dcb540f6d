// benchmark_detection [--tight RECORDING] [--json FILE] [--most-particles N]: how many box tests
// and how much time finding the close pairs of a moving ribbon takes, by brute force, by the
// paper's space enumeration and by the hierarchy, from 4x300 to 64x3200 particles, and how both
// grow. RECORDING: its last frame is the tight knot; without it only loose ribbons are measured.
// Exit code 1 when the methods do not list the same pairs, 2 when something could not be read or
// written.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/benchmark_main.h"
#include "benchmarks/measurement.h"
#include "benchmarks/solver/detector.h"
#include "benchmarks/solver/ribbon_states.h"
#include "parallel/parallel.h"
#include "simulation/detection/closest_weights.h"

namespace ribbon {
namespace {

using benchmark::Feature;
using benchmark::Method;
using benchmark::Motion;
using Json = nlohmann::ordered_json;

struct Options {
  std::string tight;
  std::string json;
  int most_particles = 64 * 3200;
};

struct Size {
  int across;
  int along;
};
constexpr std::array<Size, 8> sizes = {
    {{4, 300}, {8, 400}, {16, 400}, {16, 800}, {32, 800}, {32, 1600}, {64, 1600}, {64, 3200}}};

// Beyond this, brute force is not run: its tests are known and its time grows with them.
constexpr int most_particles_by_brute_force = 32 * 1600;

constexpr double least_s = 0.3;

struct Figure {
  double box_tests = 0;
  double time_s = 0;
  bool extrapolated = false;
};

// What is measured of one ribbon.
struct Row {
  Size size{};
  std::size_t listed = 0;  // pairs of features whose boxes meet
  std::size_t close = 0;   // of those, at most the margin apart at an end of the step
  Figure brute_force;
  Figure cells;
  double cell_factor = 0;
  Figure curvature;
  std::size_t missed_by_curvature = 0;  // close pairs that it does not list
  Figure boxes;
  Figure patches;
  double patches_two_threads_s = 0;

  [[nodiscard]] double particles() const { return size.across * size.along; }
};

// Independent of the order in which a pair's features and an edge's ends are named.
std::vector<Feature> sorted(std::vector<Feature> features) {
  for (Feature& f : features) {
    if (f[0] == 0) {
      std::sort(f.begin() + 2, f.end());
      continue;
    }
    std::sort(f.begin() + 1, f.begin() + 3);
    std::sort(f.begin() + 3, f.end());
    if (f[3] < f[1] || (f[3] == f[1] && f[4] < f[2])) {
      std::swap(f[1], f[3]);
      std::swap(f[2], f[4]);
    }
  }
  std::sort(features.begin(), features.end());
  return features;
}

double distance_m(const Feature& feature, const Eigen::Matrix3Xd& positions) {
  const FeaturePair pair{static_cast<FeaturePair::Kind>(feature[0]),
                         {feature[1], feature[2], feature[3], feature[4]}};
  const auto at = corners(pair, positions);
  return (at * closest_weights(pair.kind, at)).norm();
}

std::vector<Feature> close_pairs(const Motion& motion, const std::vector<Feature>& listed) {
  std::vector<Feature> close;
  for (const Feature& feature : listed)
    if (std::min(distance_m(feature, motion.t0), distance_m(feature, motion.t1)) <= motion.margin_m)
      close.push_back(feature);
  return close;
}

double count_tests(Method method, const Motion& motion, double cell_factor = 1) {
  const auto detector = counted::make_detector(method, motion, cell_factor);
  detector->detect();
  return static_cast<double>(detector->box_tests());
}

double time_s(Method method, const Motion& motion, double cell_factor = 1) {
  const auto detector = make_detector(method, motion, cell_factor);
  return benchmark::quickest_s(least_s, [&] { detector->detect(); });
}

std::vector<Feature> listed_by(Method method, const Motion& motion, double cell_factor = 1) {
  const auto detector = make_detector(method, motion, cell_factor);
  detector->detect();
  return sorted(detector->listed());
}

// Nothing is known about brute force beyond its limit but that it tests each pair of triangles, and
// the pairs of features that any method tests.
Figure brute_force_from(const Row& previous, const Row& row) {
  const auto pairs = [](const Row& r) {
    const double triangles = 2.0 * (r.size.across - 1) * (r.size.along - 1);
    return triangles * (triangles - 1) / 2;
  };
  const double ratio = pairs(row) / pairs(previous);
  return {previous.brute_force.box_tests * ratio, previous.brute_force.time_s * ratio, true};
}

// The cell size that suits this ribbon best.
void measure_cells(const Motion& motion, Row& row) {
  row.cells.time_s = 0;
  for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
    const double time = time_s(Method::space_enumeration, motion, factor);
    if (row.cells.time_s > 0 && row.cells.time_s <= time) continue;
    row.cells.time_s = time;
    row.cell_factor = factor;
  }
  row.cells.box_tests = count_tests(Method::space_enumeration, motion, row.cell_factor);
}

// How many of the sorted `wanted` are not among the sorted `listed`.
std::size_t missing(const std::vector<Feature>& wanted, const std::vector<Feature>& listed) {
  return static_cast<std::size_t>(
      std::count_if(wanted.begin(), wanted.end(), [&](const Feature& feature) {
        return !std::binary_search(listed.begin(), listed.end(), feature);
      }));
}

// Nothing when one that tests boxes lists others than the rest, or the gate's misses a close pair.
std::optional<Row> measure(const Size& size, const Motion& motion, const Row* previous) {
  Row row;
  row.size = size;
  set_thread_limit(1);
  const std::vector<Feature> listed = listed_by(Method::boxes, motion);
  const bool force = row.particles() <= most_particles_by_brute_force;
  measure_cells(motion, row);
  if (listed != listed_by(Method::space_enumeration, motion, row.cell_factor)) return {};
  if (force && listed != listed_by(Method::brute_force, motion)) return {};
  const std::vector<Feature> close = close_pairs(motion, listed);
  const std::vector<Feature> by_curvature = listed_by(Method::curvature, motion);
  row.listed = listed.size();
  row.close = close.size();
  row.missed_by_curvature = missing(close, by_curvature);
  if (missing(close, listed_by(Method::patches, motion)) > 0) return {};

  row.brute_force =
      force ? Figure{count_tests(Method::brute_force, motion), time_s(Method::brute_force, motion)}
            : brute_force_from(*previous, row);
  row.curvature = {count_tests(Method::curvature, motion), time_s(Method::curvature, motion)};
  row.boxes = {count_tests(Method::boxes, motion), time_s(Method::boxes, motion)};
  row.patches = {count_tests(Method::patches, motion), time_s(Method::patches, motion)};
  set_thread_limit(2);
  row.patches_two_threads_s = time_s(Method::patches, motion);
  return row;
}

void print_heading(const std::string& state) {
  std::printf("\n%s\n%-8s %9s %9s | %9s %10s | %9s %9s %4s | %9s %9s %6s | %9s %9s | %9s %9s %9s\n",
              state.c_str(), "", "listed", "close", "brute", "", "cells", "", "", "curvature", "",
              "", "boxes", "", "patches", "", "2 threads");
  std::printf("%-8s %9s %9s | %9s %10s | %9s %9s %4s | %9s %9s %6s | %9s %9s | %9s %9s %9s\n", "",
              "pairs", "pairs", "tests", "ms", "tests", "ms", "cell", "tests", "ms", "missed",
              "tests", "ms", "tests", "ms", "ms");
}

void print(const Row& row) {
  std::printf(
      "%-8s %9zu %9zu | %9.3g %9.4g%c | %9.3g %9.4g %4.1f | %9.3g %9.4g %6zu | %9.3g %9.4g | %9.3g "
      "%9.4g %9.4g\n",
      (std::to_string(row.size.across) + "x" + std::to_string(row.size.along)).c_str(), row.listed,
      row.close, row.brute_force.box_tests, 1e3 * row.brute_force.time_s,
      row.brute_force.extrapolated ? '*' : ' ', row.cells.box_tests, 1e3 * row.cells.time_s,
      row.cell_factor, row.curvature.box_tests, 1e3 * row.curvature.time_s, row.missed_by_curvature,
      row.boxes.box_tests, 1e3 * row.boxes.time_s, row.patches.box_tests, 1e3 * row.patches.time_s,
      1e3 * row.patches_two_threads_s);
  std::fflush(stdout);
}

Json json(const Figure& figure) {
  return {{"box_tests", figure.box_tests},
          {"time_s", figure.time_s},
          {"extrapolated", figure.extrapolated}};
}

Json json(const Row& row) {
  return {{"across", row.size.across},
          {"along", row.size.along},
          {"listed_pairs", row.listed},
          {"close_pairs", row.close},
          {"brute_force", json(row.brute_force)},
          {"cells", json(row.cells)},
          {"cell_factor", row.cell_factor},
          {"curvature", json(row.curvature)},
          {"missed_by_curvature", row.missed_by_curvature},
          {"boxes", json(row.boxes)},
          {"patches", json(row.patches)},
          {"patches_two_threads_s", row.patches_two_threads_s}};
}

// Exponents of tests and time against particles, of what was measured.
Json print_growth(const std::vector<Row>& rows) {
  Json exponents;
  constexpr std::array<std::pair<const char*, Figure Row::*>, 5> methods = {
      {{"brute_force", &Row::brute_force},
       {"cells", &Row::cells},
       {"curvature", &Row::curvature},
       {"boxes", &Row::boxes},
       {"patches", &Row::patches}}};
  for (const auto& [name, figure] : methods) {
    std::vector<double> particles;
    std::vector<double> tests;
    std::vector<double> times;
    for (const Row& row : rows) {
      if ((row.*figure).extrapolated) continue;
      particles.push_back(row.particles());
      tests.push_back((row.*figure).box_tests);
      times.push_back((row.*figure).time_s);
    }
    if (particles.size() < 2) continue;
    const double of_tests = benchmark::growth_exponent(particles, tests);
    const double of_time = benchmark::growth_exponent(particles, times);
    std::printf("%-12s grows with particles to the power %.2f in tests, %.2f in time\n", name,
                of_tests, of_time);
    exponents[name] = {{"tests", of_tests}, {"time", of_time}};
  }
  return exponents;
}

void describe(CLI::App& app, Options& options) {
  add_report_option(app, options.json);
  app.add_option("--tight", options.tight, "the recording whose last frame is refined")
      ->type_name("RECORDING");
  app.add_option("--most-particles", options.most_particles, "no larger ribbons");
}

Result<Motion> ribbon_in(const std::string& tight, const Size& size) {
  return tight.empty() ? loose_ribbon(RIBBON_SAMPLES "/overhand-hourglass-8x400.toml", size.along,
                                      size.across)
                       : tight_ribbon(tight, size.along, size.across);
}

// All sizes in one state: loose, or tight as in `tight`. Adds to `report`. False when the methods
// disagree.
Result<bool> measure_state(const std::string& tight, int most_particles, Json& report) {
  print_heading(tight.empty() ? "loose, as generated" : "tight, from " + tight);
  std::vector<Row> rows;
  for (const Size& size : sizes) {
    if (size.across * size.along > most_particles) break;
    const auto motion = ribbon_in(tight, size);
    if (!motion) return tl::unexpected(motion.error());
    const auto row = measure(size, *motion, rows.empty() ? nullptr : &rows.back());
    if (!row) {
      std::printf("%dx%d: the methods do not list the same pairs\n", size.across, size.along);
      return false;
    }
    rows.push_back(*row);
    print(*row);
  }
  Json state;
  for (const Row& row : rows) state["ribbons"].push_back(json(row));
  state["growth"] = print_growth(rows);
  report[tight.empty() ? "loose" : "tight"] = state;
  return true;
}

Result<ExitCode> run(const Options& options) {
  Json report;
  std::vector<std::string> states = {""};
  if (!options.tight.empty()) states.push_back(options.tight);
  for (const std::string& tight : states) {
    const auto agreed = measure_state(tight, options.most_particles, report);
    if (!agreed) return tl::unexpected(agreed.error());
    if (!*agreed) return ExitCode::answer_is_no;
  }
  std::puts(
      "\n*: extrapolated with the number of pairs of triangles. Tests: boxes against boxes, of\n"
      "triangles, regions and features. One thread but for the last column.");
  return write_report(report, options.json, ExitCode::done);
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>("benchmark_detection", argc, argv,
                                                 ribbon::describe, ribbon::run);
}

// benchmark_detection, benchmark_box_tests [--tight RECORDING] [--json FILE] [--most-particles N]:
// how much time finding the close pairs of a moving ribbon takes, and how many tests of boxes, by
// brute force, by the paper's space enumeration and by the hierarchy, from 4x300 to 64x3200
// particles, and how both grow. RECORDING: its last frame is the tight knot; without it only loose
// ribbons are measured. Exit code 1 when the methods do not list the same pairs, 2 when something
// could not be read or written.
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
#include "benchmarks/solver/detection_cost.h"
#include "benchmarks/solver/detector.h"
#include "benchmarks/solver/ribbon_states.h"
#include "parallel/parallel.h"
#include "simulation/detection/closest_weights.h"

namespace ribbon {
namespace {

using benchmark::cost_unit;
using Method = DetectionMethod;
using Pairs = std::vector<FeaturePair>;
using Json = nlohmann::ordered_json;

struct Options {
  std::string tight;
  int most_particles = 64 * 3200;
};

// Beyond this, brute force is not run: its tests are known and its time grows with them.
constexpr int most_particles_by_brute_force = 32 * 1600;

struct Figure {
  double cost = 0;
  bool extrapolated = false;
};

// What is measured of one ribbon.
struct Row {
  RibbonSize size{};
  std::size_t listed = 0;  // pairs of features whose boxes meet
  std::size_t close = 0;   // of those, at most the margin apart at an end of the step
  Figure brute_force;
  Figure cells;
  double cell_factor = 0;
  Figure curvature;
  std::size_t missed_by_curvature = 0;  // close pairs that it does not list
  Figure boxes;
  Figure patches;
  Figure patches_by_two;  // threads

  [[nodiscard]] double particles() const { return size.particles(); }
};

// By kind, then by vertices, independent of the order in which a pair's features and an edge's ends
// are named.
auto order_of(const FeaturePair& pair) {
  auto v = pair.vertices;
  if (pair.kind == FeaturePair::Kind::vertex_triangle) {
    std::sort(v.begin() + 1, v.end());
  } else {
    std::sort(v.begin(), v.begin() + 2);
    std::sort(v.begin() + 2, v.end());
    if (std::pair(v[2], v[3]) < std::pair(v[0], v[1]))
      std::rotate(v.begin(), v.begin() + 2, v.end());
  }
  return std::pair(pair.kind, v);
}
bool is_before(const FeaturePair& a, const FeaturePair& b) {
  return order_of(a) < order_of(b);
}

double distance_m(const FeaturePair& pair, const Eigen::Matrix3Xd& positions) {
  const auto at = corners(pair, positions);
  return (at * closest_weights(pair.kind, at)).norm();
}

Pairs close_pairs(const RibbonMotion& motion, const Pairs& listed) {
  Pairs close;
  for (const FeaturePair& pair : listed)
    if (std::min(distance_m(pair, motion.t0), distance_m(pair, motion.t1)) <= motion.margin_m)
      close.push_back(pair);
  return close;
}

Figure measured(Method method, const RibbonMotion& motion, double cell_factor = 1) {
  const auto detector = make_detector(method, motion, cell_factor);
  return {benchmark::cost_of([&] { (void)detector(); })};
}

// Sorted.
Pairs listed_by(Method method, const RibbonMotion& motion, double cell_factor = 1) {
  Pairs listed = make_detector(method, motion, cell_factor)();
  std::sort(listed.begin(), listed.end(), is_before);
  return listed;
}

bool are_same(const Pairs& a, const Pairs& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return order_of(x) == order_of(y); });
}

// Nothing is known about brute force beyond its limit but that it tests each pair of triangles, and
// the pairs of features that any method tests.
Figure brute_force_from(const Row& previous, const Row& row) {
  const auto pairs = [](const Row& r) {
    const double triangles = 2.0 * (r.size.across - 1) * (r.size.along - 1);
    return triangles * (triangles - 1) / 2;
  };
  return {previous.brute_force.cost * pairs(row) / pairs(previous), true};
}

// With the cell size that suits this ribbon best.
void measure_cells(const RibbonMotion& motion, Row& row) {
  for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
    const Figure figure = measured(Method::space_enumeration, motion, factor);
    if (row.cell_factor > 0 && row.cells.cost <= figure.cost) continue;
    row.cells = figure;
    row.cell_factor = factor;
  }
}

// How many of the sorted `wanted` are not among the sorted `listed`.
std::size_t missing(const Pairs& wanted, const Pairs& listed) {
  return static_cast<std::size_t>(
      std::count_if(wanted.begin(), wanted.end(), [&](const FeaturePair& pair) {
        return !std::binary_search(listed.begin(), listed.end(), pair, is_before);
      }));
}

// Nothing when one that tests boxes lists others than the rest, or the gate's misses a close pair.
std::optional<Row> measure(const RibbonSize& size, const RibbonMotion& motion,
                           const Row* previous) {
  Row row;
  row.size = size;
  set_thread_limit(1);
  const Pairs listed = listed_by(Method::boxes, motion);
  const bool force = row.particles() <= most_particles_by_brute_force;
  measure_cells(motion, row);
  if (!are_same(listed, listed_by(Method::space_enumeration, motion, row.cell_factor))) return {};
  if (force && !are_same(listed, listed_by(Method::brute_force, motion))) return {};
  const Pairs close = close_pairs(motion, listed);
  row.listed = listed.size();
  row.close = close.size();
  row.missed_by_curvature = missing(close, listed_by(Method::curvature, motion));
  if (missing(close, listed_by(Method::patches, motion)) > 0) return {};

  row.brute_force =
      force ? measured(Method::brute_force, motion) : brute_force_from(*previous, row);
  row.curvature = measured(Method::curvature, motion);
  row.boxes = measured(Method::boxes, motion);
  row.patches = measured(Method::patches, motion);
  set_thread_limit(2);
  row.patches_by_two = measured(Method::patches, motion);
  return row;
}

void print_heading(const std::string& state) {
  std::printf("\n%s, %s\n%-8s %9s %9s %10s %10s %4s %9s %6s %9s %9s %9s\n", state.c_str(),
              cost_unit().shown.c_str(), "", "listed", "close", "brute", "cells", "cell",
              "curvature", "missed", "boxes", "patches", "2 threads");
}

void print(const Row& row) {
  const auto shown = [](const Figure& figure) { return cost_unit().shown_per_unit * figure.cost; };
  std::printf("%-8s %9zu %9zu %9.4g%c %10.4g %4.1f %9.4g %6zu %9.4g %9.4g %9.4g\n",
              (std::to_string(row.size.across) + "x" + std::to_string(row.size.along)).c_str(),
              row.listed, row.close, shown(row.brute_force),
              row.brute_force.extrapolated ? '*' : ' ', shown(row.cells), row.cell_factor,
              shown(row.curvature), row.missed_by_curvature, shown(row.boxes), shown(row.patches),
              shown(row.patches_by_two));
  std::fflush(stdout);
}

Json json(const Figure& figure) {
  return {{cost_unit().name, figure.cost}, {"extrapolated", figure.extrapolated}};
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
          {"patches_by_two_threads", json(row.patches_by_two)}};
}

// Exponents against particles, of what was measured.
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
    std::vector<double> costs;
    for (const Row& row : rows) {
      if ((row.*figure).extrapolated) continue;
      particles.push_back(row.particles());
      costs.push_back((row.*figure).cost);
    }
    if (particles.size() < 2) continue;
    const double exponent = benchmark::growth_exponent(particles, costs);
    std::printf("%-12s grows with particles to the power %.2f\n", name, exponent);
    exponents[name] = exponent;
  }
  return exponents;
}

void describe(CLI::App& app, Options& options) {
  app.add_option("--tight", options.tight, "the recording whose last frame is refined")
      ->type_name("RECORDING");
  app.add_option("--most-particles", options.most_particles, "no larger ribbons");
}

Result<RibbonMotion> ribbon_in(const std::string& tight, const RibbonSize& size) {
  return tight.empty() ? loose_ribbon(RIBBON_SAMPLES "/overhand-hourglass-8x400.toml", size.along,
                                      size.across)
                       : tight_ribbon(tight, size.along, size.across);
}

// All sizes in one state: loose, or tight as in `tight`. Adds to `report`. False when the methods
// disagree.
Result<bool> measure_state(const std::string& tight, int most_particles, Json& report) {
  print_heading(tight.empty() ? "loose, as generated" : "tight, from " + tight);
  std::vector<Row> rows;
  for (const RibbonSize& size : ribbon_sizes) {
    if (size.particles() > most_particles) break;
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

Result<Findings> run(const Options& options) {
  Json report;
  std::vector<std::string> states = {""};
  if (!options.tight.empty()) states.push_back(options.tight);
  for (const std::string& tight : states) {
    const auto agreed = measure_state(tight, options.most_particles, report);
    if (!agreed) return tl::unexpected(agreed.error());
    if (!*agreed) return Findings{std::move(report), ExitCode::answer_is_no};
  }
  std::puts(
      "\n*: extrapolated with the number of pairs of triangles. One thread but for the last "
      "column.");
  return Findings{std::move(report)};
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>(RIBBON_BENCHMARK, argc, argv, ribbon::describe,
                                                 ribbon::run);
}

#include "simulation/start/width_growth.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "geometry/vectors.h"
#include "simulation/contact/contact_lengths.h"
#include "simulation/state/edge_strain.h"
#include "simulation/step/gated_step.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double growth = 1.05;            // of the width, from one width to the next
constexpr int strained_edges_percent = 1;  // that a settled band may have
constexpr int steps_per_width = 12;        // at most, to settle; one is nearly always enough
constexpr int rounds_a_width = 2;          // after each of them
constexpr double torn_strain = 1;          // of an edge that has been led round something
constexpr double noticeable = 0.01;        // of that strain
constexpr int vain_steps = 3;              // without noticeable progress

struct StrainedEdges {
  int count = 0;
  double worst = 0;
  int particle = 0;  // the first of the worst edge
};

StrainedEdges strained_edges(const RestSize& size, const Matrix3Xd& positions) {
  StrainedEdges found;
  for (const SpringFamily& family : stretch_families(size))
    for_each_spring(size.grid, family, [&](int a, int b) {
      const double strain = std::abs(edge_strain(family, a, b, positions));
      if (strain > paper_strain_limit) ++found.count;
      if (strain > found.worst) {
        found.worst = strain;
        found.particle = a;
      }
    });
  return found;
}

bool are_few(const StrainedEdges& edges, const RibbonGrid& grid) {
  const std::int64_t all = std::int64_t{2} * grid.particle_count() - grid.along - grid.across;
  return std::int64_t{100} * edges.count <= strained_edges_percent * all;
}

// An edge that is far too long and stays so is held apart by what it cannot pass, as a row is that
// has been led round an obstacle to both sides.
class TornEdge {
 public:
  bool remains(const StrainedEdges& edges) {
    const bool nears = edges.worst < (1 - noticeable) * least_;
    in_vain_ = nears ? 0 : in_vain_ + 1;
    if (nears) least_ = edges.worst;
    return edges.worst > torn_strain && in_vain_ >= vain_steps;
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  int in_vain_ = 0;
};

}  // namespace

Matrix3Xd rows_scaled(const RibbonGrid& grid, double scale, const Matrix3Xd& positions) {
  Matrix3Xd result = positions;
  for (int i = 0; i < grid.along; ++i) {
    auto row = result.middleCols(grid.particle(i, 0), grid.across);
    const Eigen::Vector3d centre = mean_of_columns(row);
    row = (scale * (row.colwise() - centre)).colwise() + centre;
  }
  return result;
}

GrowthReport grow_width(const Scene& scene, const RibbonMesh& ribbon, double fraction,
                        const StartObserver& observer, Bodies& bodies, Cloth& cloth) {
  assert(fraction > 0 && fraction <= 1 && scene.contact == ContactMethod::gate);
  GrowthReport report;
  double scale = 1;
  while (true) {
    const RestSize size = ribbon.size().narrowed(fraction);
    const std::string what =
        "the ribbon is grown to " + std::to_string(std::lround(100 * fraction)) + " % of its width";
    GatedStep step(scene, size, contact_lengths(scene, size), cloth.particle_mass_kg);
    step.move(rows_scaled(size.grid, scale, cloth.positions), bodies, cloth);
    StrainedEdges edges;
    TornEdge torn_edge;
    for (int n = 0; n < steps_per_width; ++n) {
      if (observer && !observer(what)) return report;
      step.advance_under(Matrix3Xd(3, 0), bodies, cloth);
      step.settle(rounds_a_width, bodies, cloth);
      ++report.steps;
      edges = strained_edges(size, cloth.positions);
      if (edges.count == 0 || (fraction < 1 && are_few(edges, size.grid))) break;
      if (torn_edge.remains(edges)) break;
    }
    report.strained_particle = edges.particle;
    if (!are_few(edges, size.grid)) return report;
    report.settled_fraction = fraction;
    report.complete = fraction == 1;
    if (report.complete) return report;
    scale = std::min(growth, 1 / fraction);
    fraction = std::min(1.0, growth * fraction);
  }
}

}  // namespace ribbon

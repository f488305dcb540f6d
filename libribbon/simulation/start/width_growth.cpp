#include "simulation/start/width_growth.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double growth = 1.05;            // of the width, from one stage to the next
constexpr double strained = 0.15;          // of an edge's natural length
constexpr int strained_edges_percent = 1;  // that a settled band may have
constexpr int steps_per_stage = 60;        // at most, to settle
constexpr int rounds_a_width = 2;          // after each of them

struct StrainedEdges {
  int count = 0;
  double worst = 0;
  int particle = 0;  // the first of the worst edge
};

StrainedEdges strained_edges(const NaturalSize& size, const Matrix3Xd& positions) {
  const RibbonGrid& grid = size.grid;
  StrainedEdges found;
  const auto look_at = [&](int a, int b, double natural_m) {
    const double length_m = (positions.col(b) - positions.col(a)).norm();
    const double strain = std::abs(length_m / natural_m - 1);
    if (strain > strained) ++found.count;
    if (strain > found.worst) {
      found.worst = strain;
      found.particle = a;
    }
  };
  for (int a = 0; a < grid.particle_count(); ++a) {
    if (grid.row(a) + 1 < grid.along) look_at(a, a + grid.across, size.along_m());
    if (grid.column(a) + 1 < grid.across) look_at(a, a + 1, size.across_m());
  }
  return found;
}

bool are_few(const StrainedEdges& edges, const RibbonGrid& grid) {
  const long all = 2L * grid.particle_count() - grid.along - grid.across;
  return 100L * edges.count <= strained_edges_percent * all;
}

}  // namespace

NaturalSize natural_size(const RibbonMesh& ribbon, double share) {
  return {ribbon.grid, ribbon.length_m, share * ribbon.width_m};
}

Matrix3Xd rows_scaled(const RibbonGrid& grid, double scale, const Matrix3Xd& positions) {
  Matrix3Xd result = positions;
  for (int i = 0; i < grid.along; ++i) {
    auto row = result.middleCols(grid.particle(i, 0), grid.across);
    const Eigen::Vector3d centre = row.rowwise().mean();
    row = (scale * (row.colwise() - centre)).colwise() + centre;
  }
  return result;
}

GrowthReport grow_width(const Scene& scene, const RibbonMesh& ribbon, double share, Bodies& bodies,
                        Cloth& cloth) {
  assert(share > 0 && share <= 1 && scene.contact == ContactMethod::gate);
  GrowthReport report;
  double scale = 1;
  while (true) {
    const NaturalSize size = natural_size(ribbon, share);
    Deformation deformation(scene, size, cloth.particle_mass_kg, bodies);
    deformation.move(rows_scaled(size.grid, scale, cloth.positions), cloth);
    StrainedEdges edges;
    for (int step = 0; step < steps_per_stage; ++step) {
      deformation.step({3, 0}, cloth);
      deformation.settle(rounds_a_width, cloth);
      edges = strained_edges(size, cloth.positions);
      if (edges.count == 0 || (share < 1 && are_few(edges, size.grid))) break;
    }
    report.strained_particle = edges.particle;
    if (!are_few(edges, size.grid)) return report;
    report.settled_share = share;
    report.complete = share == 1;
    if (report.complete) return report;
    scale = std::min(growth, 1 / share);
    share = std::min(1.0, growth * share);
  }
}

}  // namespace ribbon

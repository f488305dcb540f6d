#include "verification/largest_strain.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

namespace {

// Calls visit(first, second, strain) for each limited edge, for those that two quads share twice.
template <class Visit>
void visit_limited_edges(const RibbonGrid& grid, double length_m, double width_m,
                         const LimitedEdges& limited, const Eigen::Matrix3Xf& positions,
                         const Visit& visit) {
  const double along_m = length_m / (grid.along - 1);
  const double across_m = width_m / (grid.across - 1);
  const double diagonal_m = std::hypot(along_m, across_m);
  const auto look_at = [&](int first, int second, double rest_m) {
    const double length =
        (positions.col(second).cast<double>() - positions.col(first).cast<double>()).norm();
    visit(first, second, std::abs(length / rest_m - 1));
  };
  for (int q = 0; q < grid.quad_count(); ++q) {
    const auto [a, b, c, d] = grid.quad(q);
    if (limited.along) {
      look_at(a, b, along_m);
      look_at(d, c, along_m);
    }
    if (limited.across) {
      look_at(a, d, across_m);
      look_at(b, c, across_m);
    }
    if (limited.diagonals) {
      look_at(a, c, diagonal_m);
      look_at(b, d, diagonal_m);
    }
  }
}

}  // namespace

LargestStrain largest_strain(const RibbonGrid& grid, double length_m, double width_m,
                             const LimitedEdges& limited, const Eigen::Matrix3Xf& positions) {
  LargestStrain largest;
  visit_limited_edges(grid, length_m, width_m, limited, positions,
                      [&largest](int first, int second, double strain) {
                        if (strain > largest.strain) largest = {strain, first, second};
                      });
  return largest;
}

std::vector<float> particle_strains(const RibbonGrid& grid, double length_m, double width_m,
                                    const LimitedEdges& limited,
                                    const Eigen::Matrix3Xf& positions) {
  std::vector<float> strains(grid.particle_count(), 0.0F);
  visit_limited_edges(grid, length_m, width_m, limited, positions,
                      [&strains](int first, int second, double strain) {
                        const auto single = static_cast<float>(strain);
                        strains[first] = std::max(strains[first], single);
                        strains[second] = std::max(strains[second], single);
                      });
  return strains;
}

}  // namespace ribbon

#include "verification/largest_strain.h"

#include <algorithm>
#include <cmath>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

// Calls look_at(first, second, rest length) for each limited edge, for those that two quads share
// twice.
template <class LookAt>
void visit_limited_edges(const RestSize& rest, const LimitedEdges& limited, const LookAt& look_at) {
  const RibbonGrid& grid = rest.grid;
  const double along_m = rest.along_m();
  const double across_m = rest.across_m();
  const double diagonal_m = length_of(Eigen::Vector2d(along_m, across_m));
  const auto look = [&](int first, int second, double even_m) {
    look_at(first, second,
            rest.has_profile() ? length_of(rest.place_m(second) - rest.place_m(first)) : even_m);
  };
  for (int q = 0; q < grid.quad_count(); ++q) {
    const auto [a, b, c, d] = grid.quad(q);
    if (limited.along) {
      look(a, b, along_m);
      look(d, c, along_m);
    }
    if (limited.across) {
      look(a, d, across_m);
      look(b, c, across_m);
    }
    if (limited.diagonals) {
      look(a, c, diagonal_m);
      look(b, d, diagonal_m);
    }
  }
}

// Calls visit(first, second, strain) likewise.
template <class Visit>
void visit_strains(const RestSize& rest, const LimitedEdges& limited,
                   const Eigen::Matrix3Xf& positions, const Visit& visit) {
  visit_limited_edges(rest, limited, [&](int first, int second, double rest_m) {
    const double length =
        length_of(positions.col(second).cast<double>() - positions.col(first).cast<double>());
    visit(first, second, std::abs(length / rest_m - 1));
  });
}

}  // namespace

LargestStrain largest_strain(const RestSize& rest, const LimitedEdges& limited,
                             const Eigen::Matrix3Xf& positions) {
  LargestStrain largest;
  visit_strains(rest, limited, positions, [&largest](int first, int second, double strain) {
    if (strain > largest.strain) largest = {strain, first, second};
  });
  return largest;
}

std::vector<float> particle_strains(const RestSize& rest, const LimitedEdges& limited,
                                    const Eigen::Matrix3Xf& positions) {
  std::vector<float> strains(rest.grid.particle_count(), 0.0F);
  visit_strains(rest, limited, positions, [&strains](int first, int second, double strain) {
    const auto single = static_cast<float>(strain);
    strains[first] = std::max(strains[first], single);
    strains[second] = std::max(strains[second], single);
  });
  return strains;
}

}  // namespace ribbon

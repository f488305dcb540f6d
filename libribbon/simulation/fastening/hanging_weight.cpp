#include "simulation/fastening/hanging_weight.h"

#include <algorithm>
#include <cstdlib>

#include "geometry/vectors.h"
#include "ribbon_mesh/springs.h"

namespace ribbon {

using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double rounding = 1e-12;

// Strained by s along and t across, a spring of length L that reaches x and y lengthens by
// (s x^2 + t y^2) / L. The ribbon draws in across, by the t at which the energy of all is least.
// Of a band that is across_m from column to column.
double resistance_n(const RestSize& size, const SpringNetwork& springs, double across_m) {
  double along_n = 0;
  double both_n = 0;
  double across_n = 0;
  for (const SpringKind* kind : springs.kinds())
    for (const SpringFamily& family : kind->families) {
      const int in_row = std::max(0, size.grid.across - std::abs(family.columns));
      const Vector2d reach_m(family.rows * size.along_m(), family.columns * across_m);
      const double rest_m = size.has_profile() ? length_of(reach_m) : family.rest_length_m;
      const double x = reach_m.x() / rest_m;
      const double y = reach_m.y() / rest_m;
      const double squared_m = rest_m * rest_m;
      const double resists_n = kind->stiffness * in_row * squared_m / size.along_m();
      along_n += resists_n * x * x * x * x;
      both_n += resists_n * x * x * y * y;
      across_n += resists_n * y * y * y * y;
    }
  const double left_n = across_n > 0 ? along_n - both_n * both_n / across_n : along_n;
  // Diagonals alone resist nothing, but for rounding.
  return left_n > rounding * along_n ? left_n : 0;
}

}  // namespace

HangingWeight::HangingWeight(const RestSize& size, const SpringScene& stiffness,
                             double particle_mass_kg, const Vector3d& gravity_m_s2)
    : grid_(size.grid), row_weight_n_(size.grid.across * particle_mass_kg * gravity_m_s2) {
  const SpringNetwork springs = spring_network(size, stiffness);
  for (int row = 0; row < size.grid.along; ++row) {
    const bool is_new = row == 0 || size.has_profile();
    heaviness_.push_back(size.mean_rows(row, row));
    resistance_n_.push_back(is_new ? resistance_n(size, springs, size.across_m(row))
                                   : resistance_n_.front());
  }
}

const std::vector<double>& HangingWeight::strains(const Matrix3Xd& positions) {
  strains_.resize(grid_.along - 1);
  const auto row_middle = [&](int row) -> Vector3d {
    return mean_of_columns(positions.middleCols(grid_.particle(row, 0), grid_.across));
  };
  // From the end inwards; a slack ribbon bears nothing, and does not push.
  const auto add_half = [&](int end, int inwards, int edges) {
    double tension_n = 0;
    for (int i = 0; i < edges; ++i) {
      const int row = end + i * inwards;
      const Vector3d outwards = normalised(row_middle(row) - row_middle(row + inwards));
      tension_n = std::max(0.0, tension_n + heaviness_[row] * dot(row_weight_n_, outwards));
      strains_[std::min(row, row + inwards)] = tension_n > 0 ? tension_n / resistance_n_[row] : 0;
    }
  };
  const int half = (grid_.along - 1) / 2;
  add_half(0, 1, half);
  add_half(grid_.along - 1, -1, grid_.along - 1 - half);
  return strains_;
}

std::optional<HangingWeight> hanging_weight(const Scene& scene, const RestSize& size,
                                            double particle_mass_kg) {
  if (!scene.gravity_m_s2) return std::nullopt;
  return HangingWeight(size, scene.springs, particle_mass_kg, *scene.gravity_m_s2);
}

}  // namespace ribbon

#include "simulation/yielding.h"

#include <algorithm>

namespace ribbon {

namespace {

// Slow enough not to tremble, fast enough to halve the force within 14 steps.
constexpr double giving_way = 0.95;

}  // namespace

Yielding::Yielding(const RibbonGrid& grid, double length_m, double strain)
    : grid_(grid), longest_m_((1 + strain) * length_m / (grid.along - 1)) {}

double Yielding::feel(const Eigen::Matrix3Xd& positions) {
  int stretched = 0;
  for (int particle = 0; particle + grid_.across < grid_.particle_count(); ++particle) {
    const double squared_m =
        (positions.col(particle + grid_.across) - positions.col(particle)).squaredNorm();
    stretched += squared_m > longest_m_ * longest_m_ ? 1 : 0;
  }
  const int edges = grid_.particle_count() - grid_.across;
  share_ = stretched * 100 > edges ? share_ * giving_way : std::min(1.0, share_ / giving_way);
  return share_;
}

}  // namespace ribbon

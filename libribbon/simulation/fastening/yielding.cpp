#include "simulation/fastening/yielding.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

Yielding::Yielding(const RibbonGrid& grid, double length_m, double strain)
    : grid_(grid),
      rest_m_(length_m / (grid.along - 1)),
      strain_(strain),
      squared_lengths_(static_cast<std::size_t>(grid.particle_count() - grid.across)) {}

double Yielding::feel(const Eigen::Matrix3Xd& positions) {
  for (std::size_t edge = 0; edge < squared_lengths_.size(); ++edge) {
    const auto particle = static_cast<Eigen::Index>(edge);
    squared_lengths_[edge] =
        (positions.col(particle + grid_.across) - positions.col(particle)).squaredNorm();
  }
  const auto felt =
      squared_lengths_.end() - 1 - static_cast<std::ptrdiff_t>(squared_lengths_.size() / 100);
  std::nth_element(squared_lengths_.begin(), felt, squared_lengths_.end());
  const double stretch = std::sqrt(*felt) / rest_m_ - 1;
  return std::clamp(1.5 - stretch / strain_, 0.0, 1.0);
}

}  // namespace ribbon

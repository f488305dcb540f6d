#include "simulation/fastening/yielding.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

Yielding::Yielding(const RestSize& size, double strain)
    : grid_(size.grid), along_(stretch_families(size)[0]), strain_(strain) {}

double Yielding::force_fraction(const Eigen::Matrix3Xd& positions) {
  squared_lengths_.clear();
  for_each_spring(grid_, along_, [&](int a, int b) {
    squared_lengths_.push_back((positions.col(b) - positions.col(a)).squaredNorm());
  });
  const auto felt = squared_lengths_.end() - 1 - std::ssize(squared_lengths_) / 100;
  std::nth_element(squared_lengths_.begin(), felt, squared_lengths_.end());
  const double strain = std::sqrt(*felt) / along_.rest_length_m - 1;
  return std::clamp(1.5 - strain / strain_, 0.0, 1.0);
}

}  // namespace ribbon

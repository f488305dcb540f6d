#include "simulation/fastening/yielding.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/vectors.h"

namespace ribbon {

Yielding::Yielding(const RestSize& size, double strain, std::optional<HangingWeight> hanging)
    : grid_(size.grid),
      along_(stretch_families(size)[0]),
      strain_(strain),
      hanging_(std::move(hanging)) {}

double Yielding::force_fraction(const Eigen::Matrix3Xd& positions) {
  lengths_.clear();
  for (int row = 0; row + along_.rows < grid_.along; ++row) {
    double sum_m = 0;
    for_each_spring_of_row(grid_, along_, row, [&](int a, int b) {
      sum_m += length_of(positions.col(b) - positions.col(a));
    });
    lengths_.push_back(sum_m / grid_.across);
  }
  if (hanging_) {
    const std::vector<double>& strains = hanging_->strains(positions);
    for (std::size_t row = 0; row < strains.size(); ++row)
      lengths_[row] -= strains[row] * along_.rest_length_m;
  }
  const auto felt = lengths_.end() - 1 - std::ssize(lengths_) / 100;
  std::nth_element(lengths_.begin(), felt, lengths_.end());
  const double strain = *felt / along_.rest_length_m - 1;
  return std::clamp(1.5 - strain / strain_, 0.0, 1.0);
}

}  // namespace ribbon

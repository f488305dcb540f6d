#include "simulation/fastening/yielding.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/vectors.h"

namespace ribbon {

Yielding::Yielding(const RestSize& size, double strain, std::optional<HangingWeight> hanging,
                   std::optional<HeldRows> felt)
    : grid_(size.grid),
      along_(stretch_families(size)[0]),
      strain_(strain),
      felt_(felt.value_or(HeldRows{0, size.grid.along - 1})),
      hanging_(std::move(hanging)) {
  if (!size.has_profile()) return;
  for (int row = 0; row + along_.rows < grid_.along; ++row)
    row_rests_m_.push_back(mean_rest_m(grid_, along_, row));
}

double Yielding::force_fraction(const Eigen::Matrix3Xd& positions) {
  lengths_.clear();
  for (int row = felt_.first; row + along_.rows <= felt_.last; ++row) {
    double sum_m = 0;
    for_each_spring_of_row(grid_, along_, row, [&](int a, int b) {
      sum_m += length_of(positions.col(b) - positions.col(a));
    });
    lengths_.push_back(sum_m / grid_.across);
    if (!row_rests_m_.empty()) lengths_.back() *= along_.rest_length_m / row_rests_m_[row];
  }
  if (hanging_) {
    const std::vector<double>& strains = hanging_->strains(positions);
    for (std::size_t i = 0; i < lengths_.size(); ++i)
      lengths_[i] -= strains[felt_.first + i] * along_.rest_length_m;
  }
  const auto worst = lengths_.end() - 1 - std::ssize(lengths_) / 100;
  std::nth_element(lengths_.begin(), worst, lengths_.end());
  const double strain = *worst / along_.rest_length_m - 1;
  return std::clamp(1.5 - strain / strain_, 0.0, 1.0);
}

}  // namespace ribbon

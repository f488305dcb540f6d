#include "recording/lattice_frame.h"

namespace ribbon {

void LatticeFrame::positions(Eigen::Matrix3Xf& positions) const {
  if (plain) {
    positions = plain_positions;
    return;
  }
  positions.resize(3, grid.particle_count());
  for (Eigen::Index c = 0; c < 3; ++c)
    for (Eigen::Index particle = 0; particle < positions.cols(); ++particle) {
      const std::int32_t number =
          numbers[static_cast<std::size_t>(c)][static_cast<std::size_t>(particle)];
      positions(c, particle) = step_m > 0 ? metres(number, step_m) : from_ordered_number(number);
    }
}

}  // namespace ribbon

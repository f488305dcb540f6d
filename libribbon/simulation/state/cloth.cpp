#include "simulation/state/cloth.h"

namespace ribbon {

// Veltkamp's splitting (Dekker, A floating-point technique for extending the available precision,
// 1971): exactly rounded, the same bits everywhere, for speeds beyond single precision's range too.
void Cloth::round_velocities() {
  constexpr double splitter = (1 << 29) + 1;
  for (double& velocity : velocities.reshaped()) {
    const double scaled = splitter * velocity;
    velocity = scaled - (scaled - velocity);
  }
}

Eigen::ArrayXd lightness(const RestSize& size) {
  Eigen::ArrayXd result;
  if (!size.has_profile()) return result;
  result.resize(size.grid.particle_count());
  for (int particle = 0; particle < size.grid.particle_count(); ++particle)
    result[particle] = size.width_m / size.row_width_m(size.grid.row(particle));
  return result;
}

}  // namespace ribbon

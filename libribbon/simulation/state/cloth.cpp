#include "simulation/state/cloth.h"

namespace ribbon {

Eigen::ArrayXd lightness(const RestSize& size) {
  Eigen::ArrayXd result;
  if (!size.has_profile()) return result;
  result.resize(size.grid.particle_count());
  for (int particle = 0; particle < size.grid.particle_count(); ++particle)
    result[particle] = size.width_m / size.row_width_m(size.grid.row(particle));
  return result;
}

}  // namespace ribbon

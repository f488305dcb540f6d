#include "simulation/integration/spring_damping.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "parallel/instruction_set.h"

namespace ribbon {

namespace {

using Eigen::MatrixX3d;

// Reduces the speeds along the springs by twice `half_lost`, a fraction; each end takes half of the
// impulse. The compiler vectorises the loop for the registers of the function that it becomes part
// of; it believes promises that nothing overlaps only of parameters.
[[gnu::always_inline]] inline void damp_each(
    std::ptrdiff_t count, double half_lost, const double* __restrict ax,
    const double* __restrict ay, const double* __restrict az, const double* __restrict bx,
    const double* __restrict by, const double* __restrict bz, double* __restrict avx,
    double* __restrict avy, double* __restrict avz, double* __restrict bvx, double* __restrict bvy,
    double* __restrict bvz) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const double x = bx[i] - ax[i];
    const double y = by[i] - ay[i];
    const double z = bz[i] - az[i];
    const double squared = x * x + y * y + z * z;
    const double parting = x * (bvx[i] - avx[i]) + y * (bvy[i] - avy[i]) + z * (bvz[i] - avz[i]);
    // A spring without length has no direction, and nothing parts along it.
    const double half = half_lost * parting / (squared > 0 ? squared : 1);
    avx[i] += half * x;
    avy[i] += half * y;
    avz[i] += half * z;
    bvx[i] -= half * x;
    bvy[i] -= half * y;
    bvz[i] -= half * z;
  }
}

// Row by row, so that the springs from one row to another are computed several at a time; those
// within a row have particles in common and take turns.
[[gnu::always_inline]] inline void damp_family(const RibbonGrid& grid, const SpringFamily& family,
                                               double half_lost, const MatrixX3d& positions,
                                               MatrixX3d& velocities) {
  const std::ptrdiff_t offset = grid.particle(family.rows, family.columns);
  const int springs = grid.across - std::abs(family.columns);
  const std::ptrdiff_t at_once = family.rows > 0 ? springs : 1;
  const double* x = positions.col(0).data();
  const double* y = positions.col(1).data();
  const double* z = positions.col(2).data();
  double* vx = velocities.col(0).data();
  double* vy = velocities.col(1).data();
  double* vz = velocities.col(2).data();
  for (int row = 0; row + family.rows < grid.along; ++row) {
    const std::ptrdiff_t first = grid.particle(row, std::max(0, -family.columns));
    for (std::ptrdiff_t a = first; a < first + springs; a += at_once) {
      const std::ptrdiff_t b = a + offset;
      damp_each(at_once, half_lost, x + a, y + a, z + a, x + b, y + b, z + b, vx + a, vy + a,
                vz + a, vx + b, vy + b, vz + b);
    }
  }
}

void plain(const RibbonGrid& grid, const SpringFamily& family, double half_lost,
           const MatrixX3d& positions, MatrixX3d& velocities) {
  damp_family(grid, family, half_lost, positions, velocities);
}

#ifdef __x86_64__
[[gnu::target("avx2")]]
#endif
void four_at_a_time(const RibbonGrid& grid, const SpringFamily& family, double half_lost,
                    const MatrixX3d& positions, MatrixX3d& velocities) {
  damp_family(grid, family, half_lost, positions, velocities);
}

}  // namespace

void SpringDamping::apply(double h, const MatrixX3d& positions, MatrixX3d& velocities) const {
  const auto damp = instruction_set() == InstructionSet::baseline ? plain : four_at_a_time;
  for (const SpringKind* kind : network_.kinds()) {
    if (kind->stiffness == 0) continue;
    const double r = 2 * network_.damping * std::sqrt(2 * kind->stiffness / particle_mass_kg_) * h;
    const double half_lost = r < 1e300 ? 0.5 * r / (1 + r) : 0.5;
    for (const SpringFamily& family : kind->families)
      if (family.rows < network_.grid.along && std::abs(family.columns) < network_.grid.across)
        damp(network_.grid, family, half_lost, positions, velocities);
  }
}

}  // namespace ribbon

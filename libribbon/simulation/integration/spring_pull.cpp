#include "simulation/integration/spring_pull.h"

#include <cmath>

namespace ribbon {

namespace {

// Squares of shorter lengths vanish. Below it a spring pulls in proportion to its length, never
// more than its resistance times its natural length.
constexpr double shortest_m = 1e-150;

// The compiler vectorises this loop for the registers of the function that it becomes a part of. It
// believes promises that nothing overlaps only of parameters.
[[gnu::always_inline]] inline void pull_of_each(
    std::size_t count, const double* __restrict resistance, double rest_length_m,
    const double* __restrict ax, const double* __restrict ay, const double* __restrict az,
    const double* __restrict bx, const double* __restrict by, const double* __restrict bz,
    double* __restrict pull_x, double* __restrict pull_y, double* __restrict pull_z,
    double* __restrict twice_energy_j) {
  for (std::size_t i = 0; i < count; ++i) {
    const double x = bx[i] - ax[i];
    const double y = by[i] - ay[i];
    const double z = bz[i] - az[i];
    const double length_m = std::sqrt(x * x + y * y + z * z);
    const double elongation_m = length_m - rest_length_m;
    const double tension = resistance[i] * elongation_m;
    const double per_length = tension / (length_m > shortest_m ? length_m : shortest_m);
    twice_energy_j[i] = tension * elongation_m;
    pull_x[i] = per_length * x;
    pull_y[i] = per_length * y;
    pull_z[i] = per_length * z;
  }
}

[[gnu::always_inline]] inline void pull_of_each(const SpringRun& run) {
  pull_of_each(run.count, run.resistance, run.rest_length_m, run.starts[0], run.starts[1],
               run.starts[2], run.ends[0], run.ends[1], run.ends[2], run.pull[0], run.pull[1],
               run.pull[2], run.twice_energy_j);
}

void plain(const SpringRun& run) {
  pull_of_each(run);
}

#ifdef __x86_64__
[[gnu::target("avx2")]] void four_at_a_time(const SpringRun& run) {
  pull_of_each(run);
}

auto widest() {
  return __builtin_cpu_supports("avx2") != 0 ? four_at_a_time : plain;
}
#else
auto widest() {
  return plain;
}
#endif

}  // namespace

void compute_pull(const SpringRun& run) {
  static const auto compute = widest();
  compute(run);
}

}  // namespace ribbon

#include "simulation/integration/spring_run.h"

#include <cmath>

#include "parallel/instruction_set.h"

namespace ribbon {

namespace {

// Squares of shorter lengths vanish. Below it a spring pulls in proportion to its length, never
// more than its stiffness times its rest length.
constexpr double shortest_m = 1e-150;

// The rest length of every spring.
struct Alike {
  double rest_m = 0;
  double operator[](std::ptrdiff_t) const { return rest_m; }
};

// The compiler vectorises this loop for the registers of the function that it becomes a part of. It
// believes promises that nothing overlaps only of parameters.
template <bool with_energy, class RestLengths>
[[gnu::always_inline]] inline void tension_of_each(
    std::ptrdiff_t count, const double* __restrict stiffness, RestLengths rest_lengths_m,
    const double* __restrict ax, const double* __restrict ay, const double* __restrict az,
    const double* __restrict bx, const double* __restrict by, const double* __restrict bz,
    double* __restrict tension_x, double* __restrict tension_y, double* __restrict tension_z,
    double* __restrict twice_energy_j) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const double x = bx[i] - ax[i];
    const double y = by[i] - ay[i];
    const double z = bz[i] - az[i];
    const double length_m = std::sqrt(x * x + y * y + z * z);
    const double elongation_m = length_m - rest_lengths_m[i];
    const double tension_n = stiffness[i] * elongation_m;
    const double per_length = tension_n / (length_m > shortest_m ? length_m : shortest_m);
    if constexpr (with_energy) twice_energy_j[i] = tension_n * elongation_m;
    tension_x[i] = per_length * x;
    tension_y[i] = per_length * y;
    tension_z[i] = per_length * z;
  }
}

template <bool with_energy, class RestLengths>
[[gnu::always_inline]] inline void tension_of_each(const SpringRun& run,
                                                   RestLengths rest_lengths_m) {
  tension_of_each<with_energy>(run.count, run.stiffness, rest_lengths_m, run.starts[0],
                               run.starts[1], run.starts[2], run.ends[0], run.ends[1], run.ends[2],
                               run.tension[0], run.tension[1], run.tension[2], run.twice_energy_j);
}

template <bool with_energy>
[[gnu::always_inline]] inline void tension_of_each(const SpringRun& run) {
  if (run.rest_lengths_m == nullptr)
    tension_of_each<with_energy>(run, Alike{run.rest_length_m});
  else
    tension_of_each<with_energy>(run, run.rest_lengths_m);
}

[[gnu::always_inline]] inline void tension_of_each(const SpringRun& run) {
  if (run.twice_energy_j == nullptr)
    tension_of_each<false>(run);
  else
    tension_of_each<true>(run);
}

void plain(const SpringRun& run) {
  tension_of_each(run);
}

#ifdef __x86_64__
[[gnu::target("avx2")]]
#endif
void four_at_a_time(const SpringRun& run) {
  tension_of_each(run);
}

}  // namespace

void compute_tension(const SpringRun& run) {
  if (instruction_set() == InstructionSet::baseline)
    plain(run);
  else
    four_at_a_time(run);
}

}  // namespace ribbon

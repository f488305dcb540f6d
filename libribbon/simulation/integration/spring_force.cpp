#include "simulation/integration/spring_force.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "parallel/parallel.h"
#include "simulation/integration/spring_pull.h"

namespace ribbon {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixX3d;

// So many particles are at least one task: their springs fit the fast memory of a core.
constexpr Index least_grain = 1024;
// Each range also computes springs that belong to the one before it; at most one in eight.
constexpr Index grain_per_offset = 8;

void add_resistances(const SpringSet& set, std::vector<double>& sums) {
  for (const Spring& spring : set.springs) {
    sums[static_cast<std::size_t>(spring.a)] += set.resistance;
    sums[static_cast<std::size_t>(spring.b)] += set.resistance;
  }
}

}  // namespace

SpringForces::SpringForces(const SpringNetwork& network, int particle_count)
    : particle_count_(particle_count) {
  for (const SpringSet* set : {&network.stretch, &network.shear, &network.bend})
    for (const Spring& spring : set->springs) add(spring, set->resistance);
  Index farthest = 0;
  for (const Family& family : families_) farthest = std::max(farthest, family.offset);
  grain_ = std::max(least_grain, grain_per_offset * farthest);
  workspaces_.resize(static_cast<std::size_t>((particle_count_ + grain_ - 1) / grain_));
  for (Workspace& workspace : workspaces_) {
    const Index most = std::min(grain_, particle_count_) + farthest;
    workspace.pull.resize(most, 3);
    workspace.twice_energy_j.resize(most);
  }
}

void SpringForces::add(const Spring& spring, double resistance) {
  family_with_room(spring).resistance[std::min(spring.a, spring.b)] = resistance;
}

SpringForces::Family& SpringForces::family_with_room(const Spring& spring) {
  const auto [first, last] = std::minmax(spring.a, spring.b);
  const int offset = last - first;
  for (Family& family : families_)
    if (family.offset == offset && family.rest_length_m == spring.rest_length_m &&
        family.resistance[first] == 0)
      return family;
  return families_.emplace_back(
      Family{offset, spring.rest_length_m, ArrayXd::Zero(particle_count_ - offset)});
}

// Family by family: first the pull of each spring that starts or ends at the range, then what the
// particles of the range get of it.
void SpringForces::forces_on(Index begin, Index end, const MatrixX3d& positions,
                             MatrixX3d& forces) {
  Workspace& workspace = workspaces_[static_cast<std::size_t>(begin / grain_)];
  forces.middleRows(begin, end - begin).setZero();
  workspace.energy_j = 0;
  for (const Family& family : families_) {
    // Workspace and springs from the first that ends in the range to the last that starts in it.
    const Index begin_run = begin - family.offset;
    const Index first = std::max<Index>(0, begin_run);
    const Index last = std::max(first, std::min(end, particle_count_ - family.offset));
    auto pull = workspace.pull.topRows(end - begin_run);
    auto twice_energy_j = workspace.twice_energy_j.head(end - begin_run);
    pull.topRows(first - begin_run).setZero();
    pull.bottomRows(end - last).setZero();
    twice_energy_j.tail(end - last).setZero();
    SpringRun run{.count = static_cast<std::size_t>(last - first),
                  .resistance = family.resistance.data() + first,
                  .rest_length_m = family.rest_length_m,
                  .twice_energy_j = twice_energy_j.data() + (first - begin_run)};
    for (Index axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      run.starts[a] = positions.col(axis).data() + first;
      run.ends[a] = run.starts[a] + family.offset;
      run.pull[a] = pull.col(axis).data() + (first - begin_run);
    }
    compute_pull(run);
    forces.middleRows(begin, end - begin) +=
        pull.bottomRows(end - begin) - pull.topRows(end - begin);
    workspace.energy_j += twice_energy_j.tail(end - begin).sum() / 2;
  }
}

double SpringForces::forces(const MatrixX3d& positions, MatrixX3d& forces) {
  forces.resize(particle_count_, 3);
  const auto body = [&](std::size_t begin, std::size_t end) {
    forces_on(static_cast<Index>(begin), static_cast<Index>(end), positions, forces);
  };
  parallel_ranges(static_cast<std::size_t>(particle_count_), static_cast<std::size_t>(grain_),
                  std::ref(body));
  double energy_j = 0;
  for (const Workspace& workspace : workspaces_) energy_j += workspace.energy_j;
  return energy_j;
}

double fastest_frequency(const SpringNetwork& network, int particle_count,
                         double particle_mass_kg) {
  std::vector<double> sums(static_cast<std::size_t>(particle_count), 0.0);
  add_resistances(network.stretch, sums);
  add_resistances(network.shear, sums);
  add_resistances(network.bend, sums);
  // Gershgorin: no eigenvalue of the stiffness exceeds twice the largest sum at one particle.
  return std::sqrt(2 * *std::max_element(sums.begin(), sums.end()) / particle_mass_kg);
}

}  // namespace ribbon

#include "simulation/integration/spring_forces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parallel/parallel.h"
#include "simulation/integration/ordered_sums.h"
#include "simulation/integration/spring_run.h"

namespace ribbon {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixX3d;

// So many particles are at least one task: their springs fit the fast memory of a core.
constexpr Index least_grain = 1024;
// Each range also computes springs that belong to the one before it; at most one in eight.
constexpr Index grain_per_offset = 8;

}  // namespace

SpringForces::SpringForces(const SpringNetwork& network)
    : particle_count_(network.grid.particle_count()) {
  for (const SpringKind* kind : network.kinds())
    for (const SpringFamily& family : kind->families) add(family, kind->stiffness, network.grid);
  Index farthest = 0;
  for (const Family& family : families_) farthest = std::max(farthest, family.offset);
  grain_ = std::max(least_grain, grain_per_offset * farthest);
  workspaces_.resize((particle_count_ + grain_ - 1) / grain_);
  for (Workspace& workspace : workspaces_)
    workspace.tension.resize(std::min(grain_, particle_count_) + farthest, 3);
}

void SpringForces::add(const SpringFamily& family, double stiffness, const RibbonGrid& grid) {
  const Index offset = grid.particle(family.rows, family.columns);
  if (stiffness == 0 || offset >= particle_count_) return;
  Family added{offset, family.rest_length_m, family.rest_lengths_m,
               ArrayXd::Zero(particle_count_ - offset)};
  for_each_spring(grid, family, [&](int a, int) { added.stiffness[a] = stiffness; });
  families_.push_back(std::move(added));
}

// Family by family: first the tension of each spring that starts or ends at the range, then what
// the particles of the range get of it.
void SpringForces::forces_on(Index begin, Index end, bool with_energy, const MatrixX3d& positions,
                             MatrixX3d& forces) {
  Workspace& workspace = workspaces_[begin / grain_];
  forces.middleRows(begin, end - begin).setZero();
  workspace.energy_j = 0;
  Eigen::VectorXd& twice_energy_j = workspace.twice_energy_j;
  if (with_energy) twice_energy_j.resize(workspace.tension.rows());
  for (const Family& family : families_) {
    // Workspace and springs from the first that ends in the range to the last that starts in it.
    const Index begin_run = begin - family.offset;
    const Index first = std::max<Index>(0, begin_run);
    const Index last = std::max(first, std::min(end, particle_count_ - family.offset));
    auto tension = workspace.tension.topRows(end - begin_run);
    tension.topRows(first - begin_run).setZero();
    tension.bottomRows(end - last).setZero();
    SpringRun run{.count = last - first,
                  .stiffness = family.stiffness.data() + first,
                  .rest_length_m = family.rest_length_m,
                  .rest_lengths_m = family.rest_lengths_m.empty()
                                        ? nullptr
                                        : family.rest_lengths_m.data() + first};
    for (int axis = 0; axis < 3; ++axis) {
      run.starts[axis] = positions.col(axis).data() + first;
      run.ends[axis] = run.starts[axis] + family.offset;
      run.tension[axis] = tension.col(axis).data() + (first - begin_run);
    }
    if (with_energy) run.twice_energy_j = twice_energy_j.data() + (first - begin_run);
    compute_tension(run);
    // Coordinate by coordinate: as blocks of a matrix they would not be vectorised everywhere.
    for (int axis = 0; axis < 3; ++axis)
      forces.col(axis).segment(begin, end - begin) +=
          tension.col(axis).tail(end - begin) - tension.col(axis).head(end - begin);
    if (!with_energy) continue;
    twice_energy_j.segment(last - begin_run, end - last).setZero();
    workspace.energy_j += sum_of(twice_energy_j.data() + family.offset, end - begin) / 2;
  }
}

void SpringForces::compute(bool with_energy, const MatrixX3d& positions, MatrixX3d& forces) {
  forces.resize(particle_count_, 3);
  parallel_ranges(particle_count_, grain_, [&](Index begin, Index end) {
    forces_on(begin, end, with_energy, positions, forces);
  });
  if (fraction_ != 1) forces *= fraction_;
}

void SpringForces::forces(const MatrixX3d& positions, MatrixX3d& forces) {
  compute(false, positions, forces);
}

double SpringForces::forces_and_energy(const MatrixX3d& positions, MatrixX3d& forces) {
  compute(true, positions, forces);
  double energy_j = 0;
  for (const Workspace& workspace : workspaces_) energy_j += workspace.energy_j;
  return fraction_ * energy_j;
}

namespace {

// No eigenvalue of the stiffness exceeds twice the largest sum at one particle (Gershgorin): the
// smaller bound of few particles.
double most_stiffness_at_a_particle(const SpringNetwork& network) {
  std::vector<double> sums(network.grid.particle_count());
  for (const SpringKind* kind : network.kinds())
    for (const SpringFamily& family : kind->families)
      for_each_spring(network.grid, family, [&](int a, int b) {
        sums[a] += kind->stiffness;
        sums[b] += kind->stiffness;
      });
  return 2 * *std::max_element(sums.begin(), sums.end());
}

// Nor does it exceed that of the stiffest wave over an endless network whose springs all lie in the
// direction of its motion. x and y: cosines of its phase from row to row and from column to column.
double most_stiffness_of_a_wave(const SpringNetwork& network) {
  const double stretch = network.stretch.stiffness;
  const double shear = network.shear.stiffness;
  const double bend = network.bend.stiffness;
  const auto stiffness = [&](double x, double y) {
    return 2 * stretch * (2 - x - y) + 4 * shear * (1 - x * y) + 4 * bend * (2 - x * x - y * y);
  };
  const auto most_beside = [&](double y) {
    const double falls = stretch + 2 * shear * y;  // with x, at x = 0
    if (bend == 0) return stiffness(falls > 0 ? -1 : 1, y);
    return stiffness(std::clamp(-falls / (4 * bend), -1.0, 1.0), y);
  };
  const double bowed = 2 * shear + 4 * bend;
  const double within = bowed == 0 ? -1 : std::max(-stretch / bowed, -1.0);  // both x and y
  return std::max({stiffness(within, within), most_beside(1), most_beside(-1)});
}

}  // namespace

double fastest_frequency(const SpringNetwork& network, double particle_mass_kg,
                         const ArrayXd& lightness) {
  const double stiffness =
      std::min(most_stiffness_at_a_particle(network), most_stiffness_of_a_wave(network));
  const double lightest = lightness.size() > 0 ? std::max(1.0, lightness.maxCoeff()) : 1;
  return std::sqrt(stiffness * lightest / particle_mass_kg);
}

}  // namespace ribbon

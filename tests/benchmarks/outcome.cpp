#include "benchmarks/outcome.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "ribbon_mesh/springs.h"
#include "simulation/fastening_force.h"
#include "simulation/fastening_processor.h"
#include "simulation/spring_force.h"
#include "verification/frame_verifier.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double strain_limit = 0.1;  // paper, section 5.5

double particle_mass_kg(const ExtremeScene& extreme) {
  return extreme.scene.ribbon.mass_kg / extreme.mesh.grid.particle_count();
}

// Energy by positions: what the springs hold, and what moved.
class EnergyAccount {
 public:
  EnergyAccount(const ExtremeScene& extreme, const Matrix3Xd& start)
      : network_(spring_network(extreme.mesh.grid, extreme.mesh.length_m, extreme.mesh.width_m,
                                extreme.scene.springs)),
        step_s_(extreme.scene.time.step_s),
        mass_kg_(particle_mass_kg(extreme)),
        put_in_j_(elastic_j(start)) {
    if (extreme.scene.fastening)
      force_.emplace(*extreme.scene.fastening, extreme.scene.air_resistance_per_s,
                     extreme.mesh.grid, start, mass_kg_);
  }

  // Hands that yield put in less than is counted here.
  void add_step(const Matrix3Xd& before, const Matrix3Xd& after) {
    const Matrix3Xd way = after - before;
    if (force_)
      put_in_j_ += std::max(0.0, force_->at(before).leftCols(way.cols()).cwiseProduct(way).sum());
    const double kinetic_j = mass_kg_ / 2 * (way / step_s_).squaredNorm();
    const double energy_j = elastic_j(after) + kinetic_j;
    if (energy_j > 0) most_ = std::max(most_, energy_j / put_in_j_);
    is_explosion_ = is_explosion_ || energy_j > put_in_j_ + at_strain_limit_j();
  }

  // Energy over what had been put in, when that was most.
  [[nodiscard]] double most() const { return most_; }

  // Was there ever more than what had been put in and what smoothing may strain?
  [[nodiscard]] bool is_explosion() const { return is_explosion_; }

 private:
  [[nodiscard]] double elastic_j(const Matrix3Xd& positions) const {
    double sum_j = 0;
    for (const SpringSet* set : {&network_.stretch, &network_.shear, &network_.bend})
      for (const Spring& spring : set->springs) {
        const double length_m = (positions.col(spring.b) - positions.col(spring.a)).norm();
        sum_j += set->resistance / 2 * std::pow(length_m - spring.rest_length_m, 2);
      }
    return sum_j;
  }

  [[nodiscard]] double at_strain_limit_j() const {
    double sum_j = 0;
    for (const SpringSet* set : {&network_.stretch, &network_.shear, &network_.bend})
      for (const Spring& spring : set->springs)
        sum_j += set->resistance / 2 * std::pow(strain_limit * spring.rest_length_m, 2);
    return sum_j;
  }

  SpringNetwork network_;
  double step_s_;
  double mass_kg_;
  double put_in_j_;
  double most_ = 0;
  bool is_explosion_ = false;
  std::optional<FasteningForce> force_;
};

// What the strain limit cares for, whether there are springs or not.
SpringNetwork limited_edges(const ExtremeScene& extreme) {
  return spring_network(extreme.mesh.grid, extreme.mesh.length_m, extreme.mesh.width_m,
                        {.stretch = 1, .shear = extreme.scene.springs.shear > 0 ? 1.0 : 0.0});
}

// Large ribbons are judged at every tenth step.
bool is_judged(const ExtremeScene& extreme, int step) {
  return extreme.mesh.grid.particle_count() < 10'000 || step % 10 == 0 || step == extreme.steps;
}

Outcome run(const ExtremeScene& extreme, int steps, FasteningProcessor& fastening) {
  using Clock = std::chrono::steady_clock;
  const FrameVerifier verifier(extreme.mesh.grid, extreme.mesh.length_m, extreme.mesh.width_m,
                               extreme.obstacle);
  const SpringNetwork edges = limited_edges(extreme);
  Matrix3Xd before = fastening.positions();
  EnergyAccount account(extreme, before);
  Outcome outcome;
  for (int step = 1; step <= steps; ++step) {
    const auto start = Clock::now();
    fastening.step();
    outcome.time_s += std::chrono::duration<double>(Clock::now() - start).count();
    const Matrix3Xd after = fastening.positions();
    outcome.steps = step;
    outcome.is_finite = after.allFinite();
    if (!outcome.is_finite) break;
    outcome.last_strain = worst_strain(edges, after);
    outcome.worst_strain = std::max(outcome.worst_strain, outcome.last_strain);
    account.add_step(before, after);
    if (is_judged(extreme, step))
      outcome.intersecting_pairs =
          std::max(outcome.intersecting_pairs,
                   verifier.verify(after.cast<float>()).intersections.pairs.size());
    before = after;
  }
  outcome.energy = account.most();
  outcome.is_explosion = account.is_explosion();
  outcome.time_s /= std::max(1, outcome.steps);
  return outcome;
}

}  // namespace

Outcome outcome_of(const ExtremeScene& extreme, int most_steps) {
  auto fastening = FasteningProcessor::create(extreme.scene, extreme.mesh, extreme.obstacle);
  if (fastening) return run(extreme, std::min(most_steps, extreme.steps), *fastening);
  Outcome outcome;
  outcome.refusal = fastening.error().sentence();
  return outcome;
}

}  // namespace ribbon

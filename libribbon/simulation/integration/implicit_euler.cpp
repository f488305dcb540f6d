// Backward Euler as the minimum of inertia plus energy, found by a quasi-Newton method (Liu,
// Bouaziz and Kavan, "Quasi-Newton methods for real-time simulation of hyperelastic materials",
// 2017): the constant metric of the springs stands for the second derivatives, and what is learned
// on the way corrects it.
#include <algorithm>
#include <cmath>
#include <optional>

#include "simulation/integration/curvature_pairs.h"
#include "simulation/integration/flat_state.h"
#include "simulation/integration/integrator.h"
#include "simulation/integration/spring_force.h"
#include "simulation/integration/spring_metric.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixX3d;
using Eigen::RowVector3d;

// Beyond it the step ends where it is: lower than where it began, but not at the minimum.
constexpr int most_iterations = 50;
constexpr int most_trials = 8;             // of one line search
constexpr double sufficient_share = 1e-4;  // of the descent that the slope promises
constexpr double least_curvature = 1e-8;   // of the inertia's
constexpr double energy_rounding = 1e-13;  // of the energy: what its sum may be wrong by

void set_mean(const RowVector3d& mean, MatrixX3d& rows) {
  const RowVector3d shift = mean - rows.colwise().mean();
  rows.rowwise() += shift;
}

class ImplicitEuler final : public Integrator {
 public:
  ImplicitEuler(const SpringNetwork& springs, const MotionProperties& properties)
      : springs_(springs, properties.grid.particle_count()),
        properties_(properties),
        slowed_(1 / (1 + properties.step_s * properties.air_resistance_per_s)),
        inertia_(properties.particle_mass_kg / slowed_ / properties.step_s / properties.step_s) {
    if (!springs_.empty()) metric_.emplace(springs, properties.grid, inertia_);
  }

  // v' = v + h (F(x') / m - c v') and x' = x + h v' together: x' - x is the displacement where the
  // objective is least. The centre of mass moves as without springs, which is known beforehand.
  void displace(const Matrix3Xd& fastening_force, Cloth& cloth) override {
    const double h = properties_.step_s;
    state_.take(fastening_force, cloth);
    inertial_ = h * state_.velocities;
    if (state_.pull.rows() > 0) inertial_ += h * h * state_.pull;
    inertial_ *= slowed_;
    if (metric_) {
      minimise();
    } else {
      here_.displacement = inertial_;
    }
    state_.positions += here_.displacement;
    before_ = state_.velocities;
    state_.velocities = here_.displacement / h;
    if (metric_) keep_energy();
    state_.give(cloth);
  }

  [[nodiscard]] int substeps() const override { return 1; }

 private:
  // A displacement, the objective there and its gradient.
  struct Place {
    MatrixX3d displacement;
    MatrixX3d gradient;
    double elastic_j = 0;
    double objective_j = 0;
  };

  // How much inertia resists the displacement, plus the energy of the springs.
  void evaluate(Place& place) {
    moved_ = state_.positions + place.displacement;
    place.elastic_j = springs_.forces(moved_, forces_);
    place.gradient = place.displacement - inertial_;
    place.objective_j = place.elastic_j + inertia_ / 2 * place.gradient.squaredNorm();
    place.gradient = inertia_ * place.gradient - forces_;
  }

  void minimise() {
    start();
    pairs_.clear();
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      double slope_j = head_for_minimum();
      if (slope_j >= 0 && !pairs_.empty()) {
        pairs_.clear();
        slope_j = head_for_minimum();
      }
      if (-slope_j <= least_win() * squared_change()) return;
      if (!descend(slope_j) && pairs_.empty()) return;  // nothing but rounding is left to win
    }
  }

  // Begins where the last velocities lead, or without deformation where that is lower.
  void start() {
    const RowVector3d mean = inertial_.colwise().mean();
    here_.displacement = mean.replicate(inertial_.rows(), 1);
    evaluate(here_);
    undeformed_j_ = here_.elastic_j;
    there_.displacement = properties_.step_s * state_.velocities;
    set_mean(mean, there_.displacement);
    evaluate(there_);
    if (there_.objective_j < here_.objective_j) std::swap(here_, there_);
  }

  // The heading by all that is known, and the slope of the objective along it. What rounding adds
  // to the motion of the centre of mass is taken out.
  double head_for_minimum() {
    downhill_ = -here_.gradient;
    const auto solve = [this](const MatrixX3d& force, MatrixX3d& displacement) {
      metric_->solve(force, displacement);
    };
    pairs_.toward_minimum(downhill_, solve, heading_);
    set_mean(RowVector3d::Zero(), heading_);
    return dot(here_.gradient, heading_);
  }

  // What is worth another iteration, per squared change: measured against the motion itself, forces
  // that are weak for a fast ribbon would be left out for ever.
  [[nodiscard]] double least_win() const {
    return properties_.tolerance * properties_.tolerance * inertia_;
  }

  // Of the displacement against the one that the last velocities would bring.
  [[nodiscard]] double squared_change() {
    downhill_ = here_.displacement - properties_.step_s * state_.velocities;
    set_mean(RowVector3d::Zero(), downhill_);
    return downhill_.squaredNorm();
  }

  // Goes along the heading to a place that is lower, and learns from it. Stays and forgets what it
  // has learned where it finds none.
  bool descend(double slope_j) {
    double share = 1;
    for (int trial = 0; trial < most_trials; ++trial) {
      there_.displacement = here_.displacement + share * heading_;
      evaluate(there_);
      const double rise_j = there_.objective_j - here_.objective_j;
      if (rise_j <= sufficient_share * share * slope_j) {
        learn();
        std::swap(here_, there_);
        return true;
      }
      const double lowest = slope_j * share / (2 * (slope_j * share - rise_j));  // of a parabola
      share *= std::clamp(lowest, 0.1, 0.5);
    }
    pairs_.clear();
    return false;
  }

  void learn() {
    downhill_ = there_.displacement - here_.displacement;
    heading_ = there_.gradient - here_.gradient;
    pairs_.learn(downhill_, heading_, least_curvature * inertia_);
  }

  // Where a spring resists bending aside less and less, the step may reach a place of more energy
  // at the full speed. The motion about the centre of mass is slowed down to what the energy
  // before, and the work of the fastening force, leave. The line search sees to it that something
  // is left.
  void keep_energy() {
    const double m = properties_.particle_mass_kg;
    const RowVector3d mean = state_.velocities.colwise().mean();
    set_mean(RowVector3d::Zero(), before_);
    set_mean(RowVector3d::Zero(), state_.velocities);
    double energy_j = undeformed_j_ + m / 2 * before_.squaredNorm();
    energy_j += energy_rounding * energy_j;
    if (state_.pull.rows() > 0)
      energy_j += m * properties_.step_s * dot(state_.pull, state_.velocities);
    const double left_j = std::max(0.0, energy_j - here_.elastic_j);
    const double kinetic_j = m / 2 * state_.velocities.squaredNorm();
    if (kinetic_j > left_j) state_.velocities *= std::sqrt(left_j / kinetic_j);
    state_.velocities.rowwise() += mean;
  }

  SpringForces springs_;
  MotionProperties properties_;
  double slowed_;
  double inertia_;  // N/m, of one particle
  std::optional<SpringMetric> metric_;
  CurvaturePairs pairs_;
  FlatState state_;
  Place here_;
  Place there_;
  double undeformed_j_ = 0;  // the energy of the springs before the step
  MatrixX3d inertial_;       // where inertia and the fastening force alone would lead
  MatrixX3d before_;         // velocities
  MatrixX3d heading_, downhill_, moved_, forces_;
};

}  // namespace

std::unique_ptr<Integrator> implicit_euler(const SpringNetwork& springs,
                                           const MotionProperties& properties) {
  return std::make_unique<ImplicitEuler>(springs, properties);
}

}  // namespace ribbon

// Backward Euler as the minimum of inertia plus energy, found by a quasi-Newton method (Liu,
// Bouaziz and Kavan, "Quasi-Newton methods for real-time simulation of hyperelastic materials",
// 2017): a matrix that is quickly solved stands for the second derivatives, and L-BFGS corrects
// it. Theirs is constant; ours is made anew each time, of the springs as they lie.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "simulation/integration/integrator.h"
#include "simulation/integration/lbfgs_history.h"
#include "simulation/integration/ordered_sums.h"
#include "simulation/integration/particle_runs.h"
#include "simulation/integration/quasi_newton_matrix.h"

namespace ribbon {

namespace {

using Eigen::Index;
using Eigen::MatrixX3d;
using Eigen::RowVector3d;

// Beyond it the step ends where it is: lower than where it began, but not at the minimum.
constexpr int most_iterations = 50;
constexpr int most_trials = 8;                // of one line search
constexpr double sufficient_decrease = 1e-4;  // of the descent that the slope promises (Armijo)
constexpr double least_curvature = 1e-8;      // of the inertia's
constexpr double energy_rounding = 1e-13;     // of the energy: what its sum may be wrong by

// Sums in which each particle counts as much as it weighs.
class Masses {
 public:
  // As Cloth has it.
  explicit Masses(const Eigen::ArrayXd& lightness) : heaviness_(lightness.inverse()) {}

  // Of each row of the ribbon; empty: all weigh the same.
  [[nodiscard]] Eigen::ArrayXd of_rows(const RibbonGrid& grid) const {
    if (heaviness_.size() == 0) return heaviness_;
    return heaviness_(Eigen::seqN(0, grid.along, grid.across));
  }

  // Of a run of particles.
  template <class Rows>
  void weigh(Index first, Rows& run) const {
    if (heaviness_.size() > 0) run.array().colwise() *= heaviness_.segment(first, run.rows());
  }
  [[nodiscard]] double sum_of_squares(const MatrixX3d& a, Index first, Index count) const {
    if (heaviness_.size() == 0) return ribbon::sum_of_products(a, a, first, count);
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double* run = a.col(axis).data() + first;
      sum += ribbon::sum_of_products(heaviness_.data() + first, run, run, count);
    }
    return sum;
  }

  // Of all.
  double sum_of_products(const MatrixX3d& a, const MatrixX3d& b) {
    return ribbon::sum_of_products(weighed(a), b);
  }
  double sum_of_squares(const MatrixX3d& a) { return sum_of_products(a, a); }

  RowVector3d centre(const MatrixX3d& rows) { return mean_of_rows(weighed(rows)); }
  void set_centre(const RowVector3d& wanted, MatrixX3d& rows) {
    const RowVector3d shift = wanted - centre(rows);
    rows.rowwise() += shift;
  }

 private:
  const MatrixX3d& weighed(const MatrixX3d& rows) {
    if (heaviness_.size() == 0) return rows;
    weighed_ = rows.array().colwise() * heaviness_;
    return weighed_;
  }

  Eigen::ArrayXd heaviness_;  // over the mean mass; empty: all weigh the same
  MatrixX3d weighed_;
};

class ImplicitEuler final : public Integrator {
 public:
  ImplicitEuler(const SpringNetwork& springs, const MotionProperties& properties)
      : Integrator(springs, properties),
        masses_(properties.lightness),
        history_(springs_.empty() ? 0 : springs.grid.particle_count()) {
    take_substep();
    if (!springs_.empty()) matrix_.emplace(springs, inertia_, masses_.of_rows(springs.grid));
  }

  [[nodiscard]] IntegrationMethod method() const override { return IntegrationMethod::implicit; }

  void divide_steps(int parts) override {
    if (parts == substeps()) return;
    set_substeps(parts);
    take_substep();
    if (matrix_) matrix_->set_inertia(inertia_);
  }

 private:
  void take_substep() {
    slowed_ = 1 / (1 + substep_s() * properties_.air_resistance_per_s);
    inertia_ = properties_.particle_mass_kg / slowed_ / substep_s() / substep_s();
  }

  // A displacement over the substep, the objective there and its gradient.
  struct Iterate : LbfgsHistory::Place {
    double elastic_j = 0;
    double objective_j = 0;
    double squared_change = 0;  // against the displacement that the last velocities would bring
  };

  // v' = v + h (F(x') / m - c v') and x' = x + h v' together: x' - x is the displacement where the
  // objective is least. Where nobody holds it, the centre of mass moves as without springs, which
  // is known beforehand.
  void advance(double h) override {
    inertial_ = h * state_.velocities;
    if (state_.accelerations.rows() > 0) inertial_ += h * h * state_.accelerations;
    inertial_ *= slowed_;
    if (matrix_) {
      minimise();
      // Of what rounding adds.
      if (holding_.empty()) masses_.set_centre(masses_.centre(inertial_), current_.displacement);
    } else {
      current_.displacement = inertial_;
    }
    state_.positions += current_.displacement;
    before_ = state_.velocities;
    state_.velocities = current_.displacement / h;
    if (matrix_)
      keep_energy();
    else
      holding_.correct(slowed_, state_.positions, state_.velocities);
  }

  // How much inertia resists the displacement, plus the energy of the springs and of the hands that
  // hold.
  void evaluate(Iterate& iterate) {
    const Index particles = iterate.displacement.rows();
    for (MatrixX3d* result : {&moved_, &apart_, &iterate.gradient}) result->resize(particles, 3);
    for_each_particle_run(particles, [&](Index first, Index count) {
      const auto run = [&](auto& rows) { return rows.middleRows(first, count); };
      run(moved_) = run(state_.positions) + run(iterate.displacement);
    });
    iterate.elastic_j = springs_.forces_and_energy(moved_, forces_);
    const auto of_run = [&](Index first, Index count, std::array<double, 2>& squares) {
      const auto run = [&](auto& rows) { return rows.middleRows(first, count); };
      auto apart = run(apart_);
      apart = run(iterate.displacement) - run(expected_);
      squares[0] = masses_.sum_of_squares(apart_, first, count);
      apart = run(iterate.displacement) - run(inertial_);
      squares[1] = masses_.sum_of_squares(apart_, first, count);
      masses_.weigh(first, apart);
      run(iterate.gradient) = inertia_ * apart - run(forces_);
    };
    const auto [squared_change, squared_apart] = squares_.of(particles, of_run);
    iterate.squared_change = squared_change;
    iterate.objective_j = iterate.elastic_j + inertia_ / 2 * squared_apart +
                          holding_.add_energy(iterate.displacement, iterate.gradient);
  }

  void minimise() {
    holding_.begin_springs(inertia_, properties_.particle_mass_kg);
    start();
    moved_ = state_.positions + current_.displacement;
    matrix_->factor(moved_, holding_.springs(current_.displacement));
    history_.clear();
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      double slope_j = find_direction();
      if (slope_j >= 0 && !history_.empty()) {
        history_.clear();
        slope_j = find_direction();
      }
      if (expected_win(slope_j) <= least_win()) return;
      if (!search_line(slope_j)) return;  // nothing but rounding is left to win
    }
  }

  // Begins where the last velocities lead, or without deformation where that is lower.
  void start() {
    expected_ = substep_s() * state_.velocities;
    const RowVector3d mean = masses_.centre(holding_.empty() ? inertial_ : expected_);
    masses_.set_centre(mean, expected_);
    current_.displacement = mean.replicate(inertial_.rows(), 1);
    evaluate(current_);
    undeformed_j_ = current_.elastic_j;
    trial_.displacement = expected_;
    evaluate(trial_);
    if (trial_.objective_j < current_.objective_j) std::swap(current_, trial_);
  }

  // The direction by all that is known, and the slope of the objective along it.
  double find_direction() {
    return history_.toward_minimum(*matrix_, current_.gradient, direction_);
  }

  // Of a parabola that is lowest where the direction ends.
  static double expected_win(double slope_j) { return -slope_j / 2; }

  // What is worth another iteration. Measured against the motion itself and not its change, forces
  // that are weak for a fast ribbon would be left out for ever.
  [[nodiscard]] double least_win() const {
    return properties_.tolerance * properties_.tolerance * inertia_ * current_.squared_change;
  }

  // Backtracks along the direction to an iterate that is lower. Stays where it finds none.
  bool search_line(double slope_j) {
    double fraction = 1;
    for (int trial = 0; trial < most_trials; ++trial) {
      for_each_particle_run(direction_.rows(), [&](Index first, Index count) {
        const auto run = [&](auto& rows) { return rows.middleRows(first, count); };
        run(trial_.displacement) = run(current_.displacement) + fraction * run(direction_);
      });
      evaluate(trial_);
      const double rise_j = trial_.objective_j - current_.objective_j;
      if (rise_j <= sufficient_decrease * fraction * slope_j) {
        accept_trial();
        return true;
      }
      const double lowest =
          slope_j * fraction / (2 * (slope_j * fraction - rise_j));  // of a parabola
      fraction *= std::clamp(lowest, 0.1, 0.5);
    }
    return false;
  }

  void accept_trial() {
    history_.add(current_, trial_, least_curvature * inertia_);
    std::swap(current_, trial_);
  }

  // Where a spring resists bending aside less and less, the step may reach an iterate of more
  // energy at the full speed. The motion about the centre of mass is slowed down to what the energy
  // before, and the work of the hands, leave; gravity does none about that centre. The
  // line search sees to it that something is left.
  void keep_energy() {
    const double m = properties_.particle_mass_kg;
    const RowVector3d mean = masses_.centre(state_.velocities);
    masses_.set_centre(RowVector3d::Zero(), before_);
    masses_.set_centre(RowVector3d::Zero(), state_.velocities);
    double energy_j = undeformed_j_ + m / 2 * masses_.sum_of_squares(before_);
    energy_j += energy_rounding * energy_j;
    if (state_.accelerations.rows() > 0)
      energy_j +=
          m * substep_s() * masses_.sum_of_products(state_.accelerations, state_.velocities);
    energy_j += holding_.work(current_.displacement, current_.gradient, substep_s() * mean);
    const double left_j = std::max(0.0, energy_j - current_.elastic_j);
    const double kinetic_j = m / 2 * masses_.sum_of_squares(state_.velocities);
    if (kinetic_j > left_j) state_.velocities *= std::sqrt(left_j / kinetic_j);
    state_.velocities.rowwise() += mean;
  }

  double slowed_ = 0;   // the fraction of its velocity that the air leaves a particle in a substep
  double inertia_ = 0;  // N/m, of one particle of mean mass
  Masses masses_;
  std::optional<QuasiNewtonMatrix> matrix_;
  LbfgsHistory history_;
  Iterate current_;
  Iterate trial_;
  double undeformed_j_ = 0;  // the energy of the springs before it
  MatrixX3d inertial_;       // where inertia, gravity and the fastening force alone would lead
  MatrixX3d expected_;       // where the last velocities would
  MatrixX3d before_;         // velocities
  MatrixX3d direction_, apart_, moved_, forces_;
  RunSums<2> squares_;
};

}  // namespace

std::unique_ptr<Integrator> implicit_euler(const SpringNetwork& springs,
                                           const MotionProperties& properties) {
  return std::make_unique<ImplicitEuler>(springs, properties);
}

}  // namespace ribbon

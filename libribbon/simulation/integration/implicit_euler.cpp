// Backward Euler as the minimum of inertia plus energy, found by a quasi-Newton method (Liu,
// Bouaziz and Kavan, "Quasi-Newton methods for real-time simulation of hyperelastic materials",
// 2017): a constant matrix of the springs stands for the second derivatives, and L-BFGS corrects
// it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "simulation/integration/integrator.h"
#include "simulation/integration/lbfgs_history.h"
#include "simulation/integration/ordered_sums.h"
#include "simulation/integration/quasi_newton_matrix.h"

namespace ribbon {

namespace {

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

  void weigh(MatrixX3d& rows) const {
    if (heaviness_.size() > 0) rows.array().colwise() *= heaviness_;
  }

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
    weighed_ = rows;
    weigh(weighed_);
    return weighed_;
  }

  Eigen::ArrayXd heaviness_;  // over the mean mass; empty: all weigh the same
  MatrixX3d weighed_;
};

class ImplicitEuler final : public Integrator {
 public:
  ImplicitEuler(const SpringNetwork& springs, const MotionProperties& properties)
      : Integrator(springs, properties, 1, 1),
        slowed_(1 / (1 + properties.step_s * properties.air_resistance_per_s)),
        inertia_(properties.particle_mass_kg / slowed_ / properties.step_s / properties.step_s),
        masses_(properties.lightness) {
    if (!springs_.empty()) matrix_.emplace(springs, inertia_, masses_.of_rows(springs.grid));
  }

 private:
  // A displacement over the step, the objective there and its gradient.
  struct Iterate {
    MatrixX3d displacement;
    MatrixX3d gradient;
    double elastic_j = 0;
    double objective_j = 0;
  };

  // v' = v + h (F(x') / m - c v') and x' = x + h v' together: x' - x is the displacement where the
  // objective is least. The centre of mass moves as without springs, which is known beforehand.
  void advance(double h) override {
    inertial_ = h * state_.velocities;
    if (state_.accelerations.rows() > 0) inertial_ += h * h * state_.accelerations;
    inertial_ *= slowed_;
    if (matrix_) {
      minimise();
    } else {
      current_.displacement = inertial_;
    }
    state_.positions += current_.displacement;
    before_ = state_.velocities;
    state_.velocities = current_.displacement / h;
    if (matrix_) keep_energy();
  }

  // How much inertia resists the displacement, plus the energy of the springs.
  void evaluate(Iterate& iterate) {
    moved_ = state_.positions + iterate.displacement;
    iterate.elastic_j = springs_.forces(moved_, forces_);
    iterate.gradient = iterate.displacement - inertial_;
    iterate.objective_j =
        iterate.elastic_j + inertia_ / 2 * masses_.sum_of_squares(iterate.gradient);
    masses_.weigh(iterate.gradient);
    iterate.gradient = inertia_ * iterate.gradient - forces_;
  }

  void minimise() {
    start();
    history_.clear();
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      double slope_j = find_direction();
      if (slope_j >= 0 && !history_.empty()) {
        history_.clear();
        slope_j = find_direction();
      }
      if (-slope_j <= least_win() * squared_change()) return;
      if (!search_line(slope_j)) return;  // nothing but rounding is left to win
    }
  }

  // Begins where the last velocities lead, or without deformation where that is lower.
  void start() {
    const RowVector3d mean = masses_.centre(inertial_);
    current_.displacement = mean.replicate(inertial_.rows(), 1);
    evaluate(current_);
    undeformed_j_ = current_.elastic_j;
    trial_.displacement = properties_.step_s * state_.velocities;
    masses_.set_centre(mean, trial_.displacement);
    evaluate(trial_);
    if (trial_.objective_j < current_.objective_j) std::swap(current_, trial_);
  }

  // The direction by all that is known, and the slope of the objective along it. What rounding adds
  // to the motion of the centre of mass is taken out.
  double find_direction() {
    difference_ = -current_.gradient;
    history_.toward_minimum(*matrix_, difference_, direction_);
    masses_.set_centre(RowVector3d::Zero(), direction_);
    return sum_of_products(current_.gradient, direction_);
  }

  // What is worth another iteration, per squared change: measured against the motion itself, forces
  // that are weak for a fast ribbon would be left out for ever.
  [[nodiscard]] double least_win() const {
    return properties_.tolerance * properties_.tolerance * inertia_;
  }

  // Of the displacement against the one that the last velocities would bring.
  double squared_change() {
    difference_ = current_.displacement - properties_.step_s * state_.velocities;
    masses_.set_centre(RowVector3d::Zero(), difference_);
    return masses_.sum_of_squares(difference_);
  }

  // Backtracks along the direction to an iterate that is lower. Stays where it finds none.
  bool search_line(double slope_j) {
    double fraction = 1;
    for (int trial = 0; trial < most_trials; ++trial) {
      trial_.displacement = current_.displacement + fraction * direction_;
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
    difference_ = trial_.displacement - current_.displacement;
    gradient_change_ = trial_.gradient - current_.gradient;
    history_.add(difference_, gradient_change_, least_curvature * inertia_);
    std::swap(current_, trial_);
  }

  // Where a spring resists bending aside less and less, the step may reach an iterate of more
  // energy at the full speed. The motion about the centre of mass is slowed down to what the energy
  // before, and the work of the fastening force, leave; gravity does none about that centre. The
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
          m * properties_.step_s * masses_.sum_of_products(state_.accelerations, state_.velocities);
    const double left_j = std::max(0.0, energy_j - current_.elastic_j);
    const double kinetic_j = m / 2 * masses_.sum_of_squares(state_.velocities);
    if (kinetic_j > left_j) state_.velocities *= std::sqrt(left_j / kinetic_j);
    state_.velocities.rowwise() += mean;
  }

  double slowed_;   // the fraction of its velocity that the air leaves a particle in a step
  double inertia_;  // N/m, of one particle of mean mass
  Masses masses_;
  std::optional<QuasiNewtonMatrix> matrix_;
  LbfgsHistory history_;
  Iterate current_;
  Iterate trial_;
  double undeformed_j_ = 0;  // the energy of the springs before the step
  MatrixX3d inertial_;       // where inertia, gravity and the fastening force alone would lead
  MatrixX3d before_;         // velocities
  MatrixX3d direction_, gradient_change_, difference_, moved_, forces_;
};

}  // namespace

std::unique_ptr<Integrator> implicit_euler(const SpringNetwork& springs,
                                           const MotionProperties& properties) {
  return std::make_unique<ImplicitEuler>(springs, properties);
}

}  // namespace ribbon

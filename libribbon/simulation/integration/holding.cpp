#include "simulation/integration/holding.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::MatrixX3d;
using Eigen::RowVector3d;

// How fast what is held goes back to its place, whatever the step.
constexpr double return_per_s = 200;

// Of the springs that stand for hands, over the inertia of what they hold. What hangs from a
// hundredth of it lowers it by a tenth of a millimetre.
constexpr double stiff = 1e4;

// Of a particle by itself.
constexpr std::array whole = {1.0};

RowVector3d shortened(const RowVector3d& vector, double most) {
  const double length = length_of(vector);
  if (!(length > most)) return vector;
  return most / length * vector;
}

// After h seconds, of what is off its place by so much and may be accelerated by `most_m_s2`: half
// of that stops it in the end.
RowVector3d returning_velocity(const RowVector3d& off_m, const RowVector3d& velocity_m_s,
                               double most_m_s2, double h) {
  constexpr double w = return_per_s;
  const double stops_from_m = 4 * most_m_s2 / (w * w);
  const double away_m = length_of(off_m);
  const double eased = away_m > stops_from_m ? std::sqrt(stops_from_m / away_m) : 1;
  const double spring = h * w * w * eased;
  return (velocity_m_s - spring * off_m) / (1 + 2 * h * w + h * spring);
}

}  // namespace

void Holding::begin(double h, const MatrixX3d& positions, const MatrixX3d& velocities) {
  duration_s_ = h;
  elapsed_s_ += h;
  std::size_t particles = 0;
  for (const Grip& grip : grips_) particles += static_cast<std::size_t>(grip.count());
  for (std::vector<double>* of_each : {&shares_, &answers_}) {
    of_each->clear();
    of_each->reserve(particles);  // spans into it stay
  }
  helds_.clear();
  handfuls_.clear();
  for (const Grip& grip : grips_) hold(grip, positions, velocities);
}

void Holding::hold(const Grip& grip, const MatrixX3d& positions, const MatrixX3d& velocities) {
  Handful& handful = handfuls_.emplace_back();
  handful.begin = helds_.size();
  if (grip.holds_middle()) {
    const double share = 1.0 / grip.count();
    double lightness = 0;
    for (int i = 0; i < grip.count(); ++i) lightness += share * share / grip.weights[i];
    const std::size_t begun = shares_.size();
    for (int i = 0; i < grip.count(); ++i) {
      shares_.push_back(share);
      answers_.push_back(share / grip.weights[i] / lightness);
    }
    helds_.push_back({{grip.first, std::span(shares_).subspan(begun)},
                      std::span(answers_).subspan(begun),
                      1 / lightness});
  } else {
    for (int i = 0; i < grip.count(); ++i)
      helds_.push_back({{grip.first + i, whole}, whole, grip.weights[i]});
  }
  handful.end = helds_.size();
  double weight = 0;
  for (const Held& held : helds(handful)) weight += held.weight;
  handful.most_m_s2 = std::sqrt(weight) * grip.most_m_s2;
  const RowVector3d drift = grip.drift_m_s.transpose();
  const RowVector3d drifted = (elapsed_s_ - duration_s_) * drift;
  for (std::size_t i = handful.begin; i < handful.end; ++i) {
    Held& held = helds_[i];
    held.from = held.middle.of(positions);
    const RowVector3d place = grip.places.col(static_cast<Eigen::Index>(i - handful.begin));
    const RowVector3d seen =
        returning_velocity(held.from - place - drifted, held.middle.of(velocities) - drift,
                           grip.most_m_s2, duration_s_);
    held.velocity = shortened(drift + seen, grip.most_m_s);
  }
}

void Holding::correct(double slowed, MatrixX3d& positions, MatrixX3d& velocities) const {
  for (const Handful& handful : handfuls_) {
    double squared = 0;
    for (const Held& held : helds(handful))
      squared += held.weight * squared_length_of(held.velocity - held.middle.of(velocities));
    const double wanted_m_s = std::sqrt(squared);
    const double most_m_s = handful.most_m_s2 * duration_s_ * slowed;
    const double given = wanted_m_s > most_m_s ? most_m_s / wanted_m_s : 1;
    for (const Held& held : helds(handful)) {
      const RowVector3d lacking = held.velocity - held.middle.of(velocities);
      const RowVector3d way = held.from + duration_s_ * held.velocity - held.middle.of(positions);
      for (std::size_t i = 0; i < held.answers.size(); ++i) {
        const Eigen::Index particle = held.middle.first + static_cast<Eigen::Index>(i);
        velocities.row(particle) += given * held.answers[i] * lacking;
        positions.row(particle) += given * held.answers[i] * way;
      }
    }
  }
}

void Holding::begin_springs(double inertia, double particle_mass_kg) {
  stiffness_ = stiff * inertia;
  mass_kg_ = particle_mass_kg;
}

// Where it would be displaced to against where it is to be.
RowVector3d Holding::off(const Held& held, const MatrixX3d& displacement) const {
  return held.middle.of(displacement) - duration_s_ * held.velocity;
}

double Holding::root_mean_off(const Handful& handful, const MatrixX3d& displacement) const {
  double squared = 0;
  for (const Held& held : helds(handful))
    squared += held.weight * squared_length_of(off(held, displacement));
  return std::sqrt(squared);
}

// The fraction of what its springs would pull with.
double Holding::given(const Handful& handful, const MatrixX3d& displacement) const {
  const double wanted_m_s2 = stiffness_ / mass_kg_ * root_mean_off(handful, displacement);
  return wanted_m_s2 > handful.most_m_s2 ? handful.most_m_s2 / wanted_m_s2 : 1;
}

// A parabola, and beyond a hand's strength a straight line.
double Holding::add_energy(const MatrixX3d& displacement, MatrixX3d& gradient) const {
  double energy_j = 0;
  for (const Handful& handful : handfuls_) {
    const double off_m = root_mean_off(handful, displacement);
    const double part = given(handful, displacement);
    energy_j += stiffness_ * part * off_m * (off_m - part * off_m / 2);
    for (const Held& held : helds(handful))
      held.middle.add(part * stiffness_ * held.weight * off(held, displacement), gradient);
  }
  return energy_j;
}

double Holding::work(const MatrixX3d& displacement, const MatrixX3d& gradient,
                     const RowVector3d& centre) const {
  double work_j = 0;
  for (const Handful& handful : handfuls_) {
    const double part = given(handful, displacement);
    for (const Held& held : helds(handful)) {
      const RowVector3d pull = -part * stiffness_ * held.weight * off(held, displacement);
      Eigen::Index particle = held.middle.first;
      for (const double share : held.middle.shares) {
        work_j += dot((gradient.row(particle) + share * pull).eval(),
                      (displacement.row(particle) - centre).eval());
        ++particle;
      }
    }
  }
  return work_j;
}

const std::vector<SharedSpring>& Holding::springs(const MatrixX3d& displacement) {
  springs_.clear();
  for (const Handful& handful : handfuls_) {
    const double each = given(handful, displacement) * stiffness_;
    for (const Held& held : helds(handful)) springs_.push_back({held.middle, each * held.weight});
  }
  return springs_;
}

}  // namespace ribbon

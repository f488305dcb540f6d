// What hands that hold parts of the ribbon do in one part of a step.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "simulation/integration/middle.h"
#include "simulation/state/grip.h"

namespace ribbon {

// A spring that draws the middle of some particles to some place.
struct SharedSpring {
  Middle middle;
  double stiffness = 0;  // N/m
};

// Each particle of a grip, or the middle of all of them, is to go back to its place critically
// damped (a middle by the same force on each): seen from there, by the end of a part of h seconds
// at v' = (v - h s w^2 x) / (1 + 2 h w + s h^2 w^2), which is stable for any h; s is 1, or less
// where the way is so long that the hand could not stop it in the end. All accelerations a that
// this takes, of weights p, are shortened alike where the root of the sum of p a^2 is beyond that
// of p most^2: what one row needs more, another may need less.
class Holding {
 public:
  // From now on; places begin to drift. What it refers to must outlive its use.
  void take(std::span<const Grip> grips) {
    grips_ = grips;
    elapsed_s_ = 0;
  }
  [[nodiscard]] bool empty() const { return grips_.empty(); }

  // Before a part of h seconds, from positions (m) and velocities (m/s), particles x 3 each.
  void begin(double h, const Eigen::MatrixX3d& positions, const Eigen::MatrixX3d& velocities);

  // After a part that went as without hands: moves what is held to where it is to be, as far as the
  // hands are strong enough. slowed: the fraction that the air left of what a force gave.
  void correct(double slowed, Eigen::MatrixX3d& positions, Eigen::MatrixX3d& velocities) const;

  // For a scheme that finds the displacement at a minimum: hands as springs toward where they want
  // what they hold, so stiff that they hardly give way, and no stronger than they are.
  // inertia: N/m, what it costs to displace a particle of mean mass; particle_mass_kg: mean.
  void begin_springs(double inertia, double particle_mass_kg);

  // Their energy at a displacement (particles x 3), J. Adds its gradient.
  double add_energy(const Eigen::MatrixX3d& displacement, Eigen::MatrixX3d& gradient) const;

  // What they did to the particles on a displacement, seen from a place that is displaced by
  // `centre`, J. gradient: of the objective there. As far as that is not 0, they gave another force
  // than their springs would.
  [[nodiscard]] double work(const Eigen::MatrixX3d& displacement, const Eigen::MatrixX3d& gradient,
                            const Eigen::RowVector3d& centre) const;

  // At a displacement; those that are too weak as stiff as they would have to be to pull as hard.
  const std::vector<SharedSpring>& springs(const Eigen::MatrixX3d& displacement);

 private:
  // A particle, or the middle of several, that is held.
  struct Held {
    Middle middle;
    std::span<const double> answers;  // of each, to an acceleration of the middle by its shares
    double weight = 0;                // that this takes, over the mean mass of a particle
    Eigen::RowVector3d from = Eigen::RowVector3d::Zero();      // m
    Eigen::RowVector3d velocity = Eigen::RowVector3d::Zero();  // m/s, that it is to have
  };
  // What one hand holds, and what it can do.
  struct Handful {
    std::size_t begin = 0;  // of helds_
    std::size_t end = 0;
    double most_m_s2 = 0;  // as accelerations are measured
  };

  void hold(const Grip& grip, const Eigen::MatrixX3d& positions,
            const Eigen::MatrixX3d& velocities);
  [[nodiscard]] std::span<const Held> helds(const Handful& handful) const {
    return std::span(helds_).subspan(handful.begin, handful.end - handful.begin);
  }
  [[nodiscard]] Eigen::RowVector3d off(const Held& held,
                                       const Eigen::MatrixX3d& displacement) const;
  [[nodiscard]] double root_mean_off(const Handful& handful,
                                     const Eigen::MatrixX3d& displacement) const;
  [[nodiscard]] double given(const Handful& handful, const Eigen::MatrixX3d& displacement) const;

  std::span<const Grip> grips_;
  double elapsed_s_ = 0;   // at the end of the part
  double duration_s_ = 0;  // of it
  double stiffness_ = 0;   // N/m, of a spring for a particle of mean mass
  double mass_kg_ = 0;     // of that
  std::vector<double> shares_;
  std::vector<double> answers_;
  std::vector<Held> helds_;
  std::vector<Handful> handfuls_;
  std::vector<SharedSpring> springs_;
};

}  // namespace ribbon

// How a hand holds a part of the cloth.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>

namespace ribbon {

// Some particles one after the other, which a hand draws to where it wants them, critically damped,
// with the force that this takes against all else, up to its strength. What it refers to is its
// hand's, and outlives the step.
struct Grip {
  using Places = Eigen::Map<const Eigen::Matrix3Xd>;

  int first = 0;                         // particle
  std::span<const double> weights = {};  // mass of each over the mean mass of all particles
  // m, of each; or of one, where their middle is to be: with the same force on all, so that they
  // are free to turn.
  Places places{nullptr, 3, 0};
  Eigen::Vector3d drift_m_s = Eigen::Vector3d::Zero();  // of the places
  double most_m_s2 = 0;                                 // that it can accelerate them by, all alike
  double most_m_s = std::numeric_limits<double>::infinity();  // that it moves them at

  [[nodiscard]] int count() const { return static_cast<int>(weights.size()); }
  [[nodiscard]] bool holds_middle() const { return places.cols() < count(); }
};

}  // namespace ribbon

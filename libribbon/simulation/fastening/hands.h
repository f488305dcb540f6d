// What fastens a ribbon, as the time step knows it.
#pragma once

#include <Eigen/Core>
#include <span>

#include "simulation/state/cloth.h"
#include "simulation/state/grip.h"
#include "simulation/state/state_archive.h"

namespace ribbon {

class Hands {
 public:
  Hands() = default;
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;
  virtual ~Hands() = default;

  // The force for the next step, 3 x particles, N.
  virtual const Eigen::Matrix3Xd& pull(const Cloth& cloth) = 0;

  // What they hold in it, after pull().
  [[nodiscard]] virtual std::span<const Grip> grips() const { return {}; }

  // The cloth cannot bear what they pulled: they halve it. From then on they pull a little more in
  // every step.
  virtual void ease() = 0;

  // After the step: how far did the ribbon follow?
  virtual void follow(const Cloth& cloth) = 0;

  // The fraction of their force that they applied last.
  [[nodiscard]] virtual double force_fraction() const = 0;

  // FasteningProgress::recent().
  [[nodiscard]] virtual double progress() const = 0;

  // Have they done what they were to do: is the ribbon tight?
  [[nodiscard]] virtual bool are_done() const = 0;

  // All but what they remember of the last moments, which is of use only to hands that go on
  // pulling in the same way.
  virtual void visit_state(StateArchive& archive) = 0;
  virtual void visit_memory(StateArchive& archive) = 0;
};

}  // namespace ribbon

// Hands learn how much of their force the cloth can bear.
#pragma once

#include <algorithm>

#include "simulation/state/state_archive.h"

namespace ribbon {

class EasedForce {
 public:
  explicit EasedForce(double step_s) : more_(1 + more_per_s * step_s) {}

  // 0 to 1, as far as is known.
  [[nodiscard]] double bearable() const { return bearable_; }

  // It was too much.
  void ease() { bearable_ = std::max(least, bearable_ / 2); }
  // A step went well.
  void pull_more() { bearable_ = std::min(1.0, more_ * bearable_); }

  void visit_state(StateArchive& archive) {
    archive.visit(bearable_);
    if (bearable_ < 0 || bearable_ > 1) archive.refuse("the cloth can bear an impossible force");
  }

 private:
  static constexpr double least = 1e-9;
  static constexpr double more_per_s = 5;  // of what they have

  double more_;  // in a step
  double bearable_ = 1;
};

}  // namespace ribbon

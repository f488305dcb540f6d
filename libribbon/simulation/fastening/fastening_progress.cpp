#include "simulation/fastening/fastening_progress.h"

#include <algorithm>
#include <cmath>

#include "geometry/vectors.h"
#include "simulation/fastening/decay.h"

namespace ribbon {

using Eigen::Matrix3Xd;

namespace {

constexpr double window_s = 2;
constexpr int most_slots = 100;

}  // namespace

FasteningProgress::FasteningProgress(const RibbonGrid& grid, double step_s,
                                     double air_resistance_per_s)
    : grid_(grid),
      step_s_(step_s),
      air_resistance_per_s_(air_resistance_per_s),
      steps_per_slot_(
          static_cast<int>(std::min(1e9, std::ceil(window_s / step_s / most_slots - 1e-9)))),
      slots_(static_cast<std::size_t>(
          std::max(1.0, std::round(window_s / step_s / steps_per_slot_)))) {}

void FasteningProgress::visit_memory(StateArchive& archive) {
  auto& [grid, step, air_resistance, lag, steps_per_slot, steps_in_slot, slot, slots, is_full] =
      *this;
  archive.visit(steps_in_slot, 0, steps_per_slot);
  archive.visit(slot, 0, std::ssize(slots) - 1);
  for (Slot& sums : slots)
    for (auto* halves : {&sums.moved_m, &sums.commanded_m})
      for (double& metres : *halves) archive.visit(metres);
  archive.visit(is_full);
}

// The oldest slot makes room when this one has had its steps.
FasteningProgress::Slot& FasteningProgress::slot_of_this_step() {
  if (steps_in_slot_ == steps_per_slot_) {
    slot_ = (slot_ + 1) % std::ssize(slots_);
    slots_[slot_] = {};
    steps_in_slot_ = 0;
  }
  ++steps_in_slot_;
  is_full_ = is_full_ || (slot_ + 1 == std::ssize(slots_) && steps_in_slot_ == steps_per_slot_);
  return slots_[slot_];
}

// For how long a free particle that started at rest would have to move at the commanded velocity to
// get as far as it does in this step: v' = air (command - v).
double FasteningProgress::free_travel_s() {
  const double lost = decayed(air_resistance_per_s_ * step_s_);
  const double travel_s = step_s_ - lag_ * lost / air_resistance_per_s_;
  lag_ *= 1 - lost;
  return travel_s;
}

void FasteningProgress::add(const Matrix3Xd& command, const Matrix3Xd& before,
                            const Matrix3Xd& after) {
  Slot& slot = slot_of_this_step();
  const double travel_s = free_travel_s();
  for (int particle = 0; particle < grid_.particle_count(); ++particle) {
    const double speed_m_s = length_of(command.col(particle));
    if (speed_m_s == 0) continue;
    const int half = 2 * grid_.row(particle) < grid_.along ? 0 : 1;
    slot.moved_m[half] +=
        dot(command.col(particle), after.col(particle) - before.col(particle)) / speed_m_s;
    slot.commanded_m[half] += speed_m_s * travel_s;
  }
}

double FasteningProgress::recent() const {
  Slot sum;
  for (const Slot& slot : slots_)
    for (int half = 0; half < 2; ++half) {
      sum.moved_m[half] += slot.moved_m[half];
      sum.commanded_m[half] += slot.commanded_m[half];
    }
  const auto progress = [&sum](int half) {
    return sum.commanded_m[half] > 0 ? sum.moved_m[half] / sum.commanded_m[half] : 1;
  };
  return std::max(progress(0), progress(1));
}

}  // namespace ribbon

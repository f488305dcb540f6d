#include "simulation/fastening/fastening_progress.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/vectors.h"
#include "simulation/fastening/decay.h"

namespace ribbon {

using Eigen::Matrix3Xd;

namespace {

constexpr double window_s = 2;
constexpr int most_slots = 100;
constexpr double standstill = 0.03;

std::size_t count_groups(const std::vector<int>& group_of_row) {
  int highest = -1;
  for (const int group : group_of_row) highest = std::max(highest, group);
  return static_cast<std::size_t>(highest) + 1;
}

}  // namespace

FasteningProgress::FasteningProgress(const RibbonGrid& grid, std::vector<int> group_of_row,
                                     double step_s, double air_resistance_per_s)
    : grid_(grid),
      group_of_row_(std::move(group_of_row)),
      groups_(count_groups(group_of_row_)),
      step_s_(step_s),
      air_resistance_per_s_(air_resistance_per_s),
      steps_per_slot_(
          static_cast<int>(std::clamp(std::ceil(window_s / step_s / most_slots - 1e-9), 1.0, 1e9))),
      slots_(
          static_cast<std::size_t>(std::max(1.0, std::round(window_s / step_s / steps_per_slot_))),
          Slot{std::vector<double>(groups_), std::vector<double>(groups_)}) {}

void FasteningProgress::visit_memory(StateArchive& archive) {
  auto& [grid, group_of_row, groups, step, air_resistance, lag, steps_per_slot, steps_in_slot, slot,
         slots, is_full] = *this;
  archive.visit(steps_in_slot, 0, steps_per_slot);
  archive.visit(slot, 0, std::ssize(slots) - 1);
  for (Slot& sums : slots)
    for (auto* of_groups : {&sums.moved_m, &sums.commanded_m})
      for (double& metres : *of_groups) archive.visit(metres);
  archive.visit(is_full);
}

// The oldest slot makes room when this one has had its steps.
FasteningProgress::Slot& FasteningProgress::slot_of_this_step() {
  if (steps_in_slot_ == steps_per_slot_) {
    slot_ = (slot_ + 1) % std::ssize(slots_);
    for (auto* of_groups : {&this_slot().moved_m, &this_slot().commanded_m})
      std::fill(of_groups->begin(), of_groups->end(), 0);
    steps_in_slot_ = 0;
  }
  ++steps_in_slot_;
  is_full_ = is_full_ || (slot_ + 1 == std::ssize(slots_) && steps_in_slot_ == steps_per_slot_);
  return this_slot();
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
    const int group = group_of_row_[grid_.row(particle)];
    if (speed_m_s == 0 || group < 0) continue;
    slot.moved_m[group] +=
        dot(command.col(particle), after.col(particle) - before.col(particle)) / speed_m_s;
    slot.commanded_m[group] += speed_m_s * travel_s;
  }
}

FasteningProgress::Range FasteningProgress::of_groups() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range range{infinity, -infinity};
  for (std::size_t group = 0; group < groups_; ++group) {
    double moved_m = 0;
    double commanded_m = 0;
    for (const Slot& slot : slots_) {
      moved_m += slot.moved_m[group];
      commanded_m += slot.commanded_m[group];
    }
    if (commanded_m == 0) continue;
    const double progress = moved_m / commanded_m;
    range = {std::min(range.slowest, progress), std::max(range.fastest, progress)};
  }
  return range.fastest >= range.slowest ? range : Range{1, 1};
}

double FasteningProgress::recent() const {
  return of_groups().fastest;
}

bool FasteningProgress::is_at_standstill() const {
  const Range range = of_groups();
  return is_full_ && range.slowest > -standstill && range.fastest < standstill;
}

std::vector<int> halves(const RibbonGrid& grid) {
  std::vector<int> groups(grid.along);
  for (int row = 0; row < grid.along; ++row) groups[row] = 2 * row < grid.along ? 0 : 1;
  return groups;
}

}  // namespace ribbon

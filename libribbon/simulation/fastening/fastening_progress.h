// How far fastening gets, against how far the force would take a free ribbon.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/ribbon_grid.h"
#include "simulation/state/state_archive.h"

namespace ribbon {

// The distance that the particles of each half went along the force in the last two seconds, over
// the distance that they would have gone without springs and contact. A ribbon that slides through
// its knot from one half to the other is as far from locked as one that is drawn tight, so the
// faster half counts.
class FasteningProgress {
 public:
  // air_resistance_per_s > 0: what a free particle is slowed by; steps of step_s.
  FasteningProgress(const RibbonGrid& grid, double step_s, double air_resistance_per_s);

  // One step. command: 3 x particles, m/s, the terminal velocities that all of the fastening force
  // would reach against the air; before, after: 3 x particles.
  void add(const Eigen::Matrix3Xd& command, const Eigen::Matrix3Xd& before,
           const Eigen::Matrix3Xd& after);

  // 1: free, 0: locked, below 0: the ribbon draws the hands back. Since the start, where that was
  // less than two seconds ago; 1 where nothing was commanded.
  [[nodiscard]] double recent() const;

  // Have two seconds passed since the start?
  [[nodiscard]] bool knows_all() const { return is_full_; }

  // How fast the ribbon already is, and then what is remembered of the last two seconds.
  void visit_state(StateArchive& archive) { archive.visit(lag_); }
  void visit_memory(StateArchive& archive);

 private:
  // Sums of some steps: the last two seconds are a ring of slots, so that none is stored for each
  // step.
  struct Slot {
    std::array<double, 2> moved_m{};  // of the first and the second half
    std::array<double, 2> commanded_m{};
  };

  Slot& slot_of_this_step();
  double free_travel_s();

  RibbonGrid grid_;
  double step_s_;
  double air_resistance_per_s_;
  double lag_ = 1;  // the fraction of the command that a free particle still falls short of
  int steps_per_slot_;
  int steps_in_slot_ = 0;
  std::int64_t slot_ = 0;  // of the last step
  std::vector<Slot> slots_;
  bool is_full_ = false;
};

}  // namespace ribbon

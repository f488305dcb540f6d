// How far fastening gets, against how far the force would take a free ribbon.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/ribbon_grid.h"
#include "simulation/state/state_archive.h"

namespace ribbon {

// The distance that the particles of each group of rows went along the force in the last two
// seconds, over the distance that they would have gone without springs and contact. A ribbon that
// slides through its knot from one half to the other is as far from locked as one that is drawn
// tight, so the fastest group counts.
class FasteningProgress {
 public:
  // Groups count from 0; group_of_row: one for each row, -1 for rows that are not asked.
  // air_resistance_per_s > 0: what a free particle is slowed by; steps of step_s.
  FasteningProgress(const RibbonGrid& grid, std::vector<int> group_of_row, double step_s,
                    double air_resistance_per_s);

  // One step. command: 3 x particles, m/s, the terminal velocities that all of the fastening force
  // would reach against the air; before, after: 3 x particles.
  void add(const Eigen::Matrix3Xd& command, const Eigen::Matrix3Xd& before,
           const Eigen::Matrix3Xd& after);

  // 1: free, 0: locked, below 0: the ribbon draws the hands back. Since the start, where that was
  // less than two seconds ago. Groups to which nothing was commanded do not count; 1 where all are.
  [[nodiscard]] double recent() const;

  // Have two seconds passed since the start, and is it of each group less than 3 % either way?
  [[nodiscard]] bool is_at_standstill() const;

  // How fast the ribbon already is, and then what is remembered of the last two seconds.
  void visit_state(StateArchive& archive) { archive.visit(lag_); }
  void visit_memory(StateArchive& archive);

 private:
  // Sums of some steps: the last two seconds are a ring of slots, so that none is stored for each
  // step.
  struct Slot {
    std::vector<double> moved_m;  // one for each group
    std::vector<double> commanded_m;
  };

  struct Range {
    double slowest;
    double fastest;
  };

  [[nodiscard]] Range of_groups() const;
  Slot& slot_of_this_step();
  Slot& this_slot() { return slots_[static_cast<std::size_t>(slot_)]; }
  double free_travel_s();

  RibbonGrid grid_;
  std::vector<int> group_of_row_;
  std::size_t groups_;
  double step_s_;
  double air_resistance_per_s_;
  double lag_ = 1;  // the fraction of the command that a free particle still falls short of
  int steps_per_slot_;
  int steps_in_slot_ = 0;
  std::int64_t slot_ = 0;  // of the last step
  std::vector<Slot> slots_;
  bool is_full_ = false;
};

// The groups of a ribbon that is pulled as a whole.
std::vector<int> halves(const RibbonGrid& grid);

}  // namespace ribbon

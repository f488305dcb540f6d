// What still moves while the strain correction sweeps over the ribbon, so that sweeps pass over the
// rest: what has not moved since it was last looked at is as it was left.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// What looks at the ribbon in each sweep: contact, and then the families of edges.
inline constexpr std::size_t contact_task = 0;
inline constexpr std::size_t first_family_task = 1;

class SweepActivity {
 public:
  // Of a ribbon at which none of so many tasks has looked.
  SweepActivity(const RibbonGrid& grid, std::size_t tasks)
      : last_moved_(grid.along, 0),
        last_turn_(tasks, 0),
        row_of_(grid.particle_count()),
        travelled_m_(static_cast<std::size_t>(grid.particle_count()) + 1, 0) {
    for (std::size_t particle = 0; particle < row_of_.size(); ++particle)
      row_of_[particle] = grid.row(static_cast<int>(particle));
  }

  // As if none of the tasks had looked at anything, and nothing had moved.
  void reset() {
    std::fill(last_turn_.begin(), last_turn_.end(), 0);
    std::fill(travelled_m_.begin(), travelled_m_.end(), 0);
  }

  // A task begins to look at all rows, one after the other.
  void begin(std::size_t task) {
    since_ = last_turn_[task];
    last_turn_[task] = ++turn_;
  }
  void move(int particle, double by_m) {
    last_moved_[row_of_[particle]] = turn_;
    travelled_m_[particle] += by_m;
  }

  // Has the row stayed where it was since the task last began? Not if it was never looked at.
  [[nodiscard]] bool is_resting(int row) const { return last_moved_[row] < since_; }

  // How far four vertices have moved since the last reset, together. Those that are not the
  // ribbon's have the number after its last.
  [[nodiscard]] double travelled_m(const std::array<int, 4>& vertices) const {
    return (travelled_m_[vertices[0]] + travelled_m_[vertices[1]]) +
           (travelled_m_[vertices[2]] + travelled_m_[vertices[3]]);
  }

 private:
  std::vector<std::int64_t> last_moved_;  // turns, of the rows
  std::vector<std::int64_t> last_turn_;
  std::int64_t turn_ = 0;
  std::int64_t since_ = 0;
  std::vector<int> row_of_;          // of the particles
  std::vector<double> travelled_m_;  // by the particles; then 0, for what is not the ribbon's
};

}  // namespace ribbon

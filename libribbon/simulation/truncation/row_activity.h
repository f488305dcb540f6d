// Which rows of the ribbon still move while the strain correction sweeps over them, so that sweeps
// pass over the others: what neither end of has moved since it was last looked at is as it was
// left.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ribbon {

// What looks at the rows in each sweep: contact, and then the families of edges.
inline constexpr std::size_t contact_task = 0;
inline constexpr std::size_t first_family_task = 1;

class RowActivity {
 public:
  // So many rows, none of which any of so many tasks has looked at.
  RowActivity(int rows, std::size_t tasks) : last_moved_(rows, 0), last_turn_(tasks, 0) {}

  // As if none of the tasks had looked at any row.
  void reset() { std::fill(last_turn_.begin(), last_turn_.end(), 0); }

  // A task begins to look at all rows, one after the other.
  void begin(std::size_t task) {
    since_ = last_turn_[task];
    last_turn_[task] = ++turn_;
  }
  void move(int row) { last_moved_[row] = turn_; }

  // Has the row stayed where it was since the task last began? Not if it was never looked at.
  [[nodiscard]] bool is_resting(int row) const { return last_moved_[row] < since_; }

 private:
  std::vector<long> last_moved_;  // turns
  std::vector<long> last_turn_;
  long turn_ = 0;
  long since_ = 0;
};

}  // namespace ribbon

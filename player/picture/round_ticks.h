// Round numbers for axes and legends.
#pragma once

#include <string>
#include <vector>

namespace ribbon {

struct Ticks {
  std::vector<double> values;  // ascending
  int digits = 0;              // behind the point, as many as tell them apart

  // Such as "0.05".
  [[nodiscard]] std::string text(double value) const;
};

// Multiples of 1, 2 or 5 times a power of ten from `low` to `high`, which must be finite: as many
// as there are with at most `most` (at least 2), and none where low is not below high.
Ticks round_ticks(double low, double high, int most);

}  // namespace ribbon

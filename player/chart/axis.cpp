#include "player/chart/axis.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

ChartAxis::ChartAxis(double low, double high, float begin, float end, int most_ticks)
    : low_(low),
      high_(std::max(high, low + std::max(1e-9, 1e-6 * std::abs(low)))),
      begin_(begin),
      end_(end),
      ticks_(round_ticks(low_, high_, most_ticks)) {}

float ChartAxis::place(double value) const {
  const double along = (value - low_) / (high_ - low_);
  return begin_ + static_cast<float>(along) * (end_ - begin_);
}

}  // namespace ribbon

// From values to places on a page.
#pragma once

#include "player/picture/round_ticks.h"

namespace ribbon {

class ChartAxis {
 public:
  // Values from low to high, which must be finite, between two places in pixels. Ends that are the
  // same are moved apart.
  ChartAxis(double low, double high, float begin, float end, int most_ticks);

  [[nodiscard]] float place(double value) const;
  [[nodiscard]] const Ticks& ticks() const { return ticks_; }

 private:
  double low_;
  double high_;
  float begin_;
  float end_;
  Ticks ticks_;
};

}  // namespace ribbon

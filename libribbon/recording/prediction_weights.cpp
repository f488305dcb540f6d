#include "recording/prediction_weights.h"

#include <cmath>

namespace ribbon {

Weights RecordedWeights::weights() const {
  Weights result{};
  for (std::size_t stage = 0; stage < prediction_stage_count; ++stage)
    for (std::size_t tap = 0; tap < most_taps; ++tap)
      result[stage][tap] = std::ldexp(static_cast<float>(numbers[stage][tap]), -shift);
  return result;
}

}  // namespace ribbon

#include "recording/codec/prediction_weights.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

Weights RecordedWeights::weights() const {
  const auto scale = [this](const auto& numbers, auto& floats) {
    std::transform(numbers.begin(), numbers.end(), floats.begin(), [this](std::int32_t number) {
      return std::ldexp(static_cast<float>(number), -shift);
    });
  };
  Weights result;
  for (std::size_t stage = 0; stage < prediction_stage_count; ++stage) {
    scale(stages[stage].near, result[stage].near);
    scale(stages[stage].past, result[stage].past);
  }
  return result;
}

}  // namespace ribbon

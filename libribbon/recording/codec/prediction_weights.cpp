#include "recording/codec/prediction_weights.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

Weights RecordedWeights::weights() const {
  const auto scaled = [this](std::int32_t number) {
    return std::ldexp(static_cast<float>(number), -shift);
  };
  Weights result;
  for (std::size_t stage = 0; stage < prediction_stage_count; ++stage) {
    std::ranges::transform(stages[stage].near, result[stage].near.begin(), scaled);
    std::ranges::transform(stages[stage].past, result[stage].past.begin(), scaled);
  }
  return result;
}

}  // namespace ribbon

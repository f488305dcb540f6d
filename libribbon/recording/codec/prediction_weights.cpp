#include "recording/codec/prediction_weights.h"

#include <cmath>

namespace ribbon {

namespace {

template <std::size_t count>
void scale(const std::int32_t* numbers, int shift, std::array<float, count>& weights) {
  for (std::size_t tap = 0; tap < count; ++tap)
    weights[tap] = std::ldexp(static_cast<float>(numbers[tap]), -shift);
}

}  // namespace

Weights RecordedWeights::of_first_column() const {
  Weights weights;
  scale(first.data(), shift, weights.past);
  return weights;
}

Weights RecordedWeights::of_others() const {
  Weights weights;
  scale(others.data(), shift, weights.past);
  scale(others.data() + past_taps, shift, weights.near);
  return weights;
}

}  // namespace ribbon

// Finds the linear prediction that suits a frame best. Only the encoder needs it: what it finds is
// recorded, so decoders do not depend on how it was found.
#pragma once

#include <span>
#include <vector>

#include "recording/prediction.h"

namespace ribbon {

// Taps and wanted value of some of a frame's particles.
struct Sample {
  Taps taps;
  std::int32_t wanted = 0;
};

struct Fit {
  Predictor predictor;  // its base is left to the caller
  double bits = 0;      // estimated size of the residuals and coefficients
};

// Least squares over the samples for each of the tap counts in `choices`; of these the one that
// costs the fewest bits for `particles` particles. The same samples give
// the same bits on any IEEE machine: plain double arithmetic in a fixed order.
Fit fit_predictor(const std::vector<Sample>& samples, std::span<const int> choices, int particles);

}  // namespace ribbon

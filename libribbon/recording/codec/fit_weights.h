// Finds the weights that predict a frame best. Only the encoder needs it: what it finds is
// recorded, so decoders do not depend on how it was found.
#pragma once

#include "recording/codec/frame_prediction.h"

namespace ribbon {

// Least squares over some of the particles, the same weights for x, y and z; restless ones count
// less. prediction: begun, not of an intra frame, with the frame's values continued over ends. The
// same bits on any IEEE machine: plain arithmetic in a fixed order.
RecordedWeights fit_weights(const FramePrediction& prediction, Residuals& residuals);

}  // namespace ribbon

// Finds the weights that predict a frame best. Only the encoder needs it: what it finds is
// recorded, so decoders do not depend on how it was found.
#pragma once

#include <cstdint>

#include "recording/codec/frame_loops.h"

namespace ribbon {

// How many particles the weights are made from: some, or all of them. Frames get a hundredth
// smaller for several times the work.
enum class Fit : std::uint8_t { quick, thorough };

// Least squares over particles, the same weights for x, y and z; restless ones count less. frame:
// with values and motion, its borders closed. The same bits on any IEEE machine: plain
// arithmetic in a fixed order.
RecordedWeights fit_weights(const PredictedFrame& frame, Fit fit);

// Likewise for an intra frame; values: of all particles, borders continued plane by plane.
IntraWeights fit_intra_weights(const PolyphasePlanes& planes, const PlaneFields<float>& values);

}  // namespace ribbon

// Values of a frame to residuals and back: what the encoder and the decoder have in common.
#pragma once

#include <span>

#include "recording/codec/codec_parameters.h"
#include "recording/codec/frame_loops.h"
#include "recording/codec/quantised_frame.h"
#include "recording/codec/residual_blocks.h"

namespace ribbon {

// Keeps its memory between frames.
class FramePrediction {
 public:
  explicit FramePrediction(const CodecParameters& parameters);

  // Begins a frame. references: none of them plain, and they must live until it ends; none at all:
  // it is an intra frame.
  void begin(Prediction prediction, std::span<const QuantisedFrame* const> references);

  [[nodiscard]] Prediction prediction() const { return frame_.prediction; }
  [[nodiscard]] const PolyphasePlanes& planes() const { return planes_; }

  Weights weights{};             // of P and B frames
  IntraWeights intra_weights{};  // of intra frames

  // Makes the values of `frame` from residuals.
  void decode(Residuals& residuals, QuantisedFrame& frame);

  // Takes the frame that is to be fitted and encoded.
  void set(QuantisedFrame& frame);
  // What it is fitted to, its motion included, borders closed.
  [[nodiscard]] const PredictedFrame& predicted() const { return frame_; }
  [[nodiscard]] const PlaneFields<float>& motion() const { return motion_; }
  // Makes the residuals of the frame.
  void encode(Residuals& residuals);

 private:
  void set_fields(QuantisedFrame& frame);

  PolyphasePlanes planes_;
  PlaneFields<float> motion_;
  PredictedFrame frame_;
};

}  // namespace ribbon

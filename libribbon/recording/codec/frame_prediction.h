// A frame between its values and its ranks: what the encoder and the decoder have in common.
#pragma once

#include <span>

#include "recording/codec/codec_parameters.h"
#include "recording/codec/frame_loops.h"
#include "recording/codec/lattice_frame.h"
#include "recording/codec/rank_blocks.h"

namespace ribbon {

// Keeps its memory between frames.
class FramePrediction {
 public:
  explicit FramePrediction(const CodecParameters& parameters);

  // Begins a frame. references: none of them plain, and they must live until it ends; none at all:
  // it is predicted within itself.
  void begin(Prediction prediction, std::span<const LatticeFrame* const> references);

  [[nodiscard]] Prediction prediction() const { return frame_.prediction; }
  [[nodiscard]] const ParityPlanes& planes() const { return planes_; }

  Weights weights{};               // used unless the frame is predicted within itself
  WithinWeights within_weights{};  // used if it is

  // Makes the values of `frame` from ranks.
  void decode(Ranks& ranks, LatticeFrame& frame);

  // Takes the frame that is to be fitted and ranked.
  void set(LatticeFrame& frame);
  // What it is fitted to, its motion included, borders closed.
  [[nodiscard]] const PredictedFrame& predicted() const { return frame_; }
  [[nodiscard]] const PlaneFields<float>& motion() const { return motion_; }
  // Makes the ranks of the frame.
  void rank(Ranks& ranks);

 private:
  void set_fields(LatticeFrame& frame);

  ParityPlanes planes_;
  PlaneFields<float> motion_;
  PredictedFrame frame_;
};

}  // namespace ribbon

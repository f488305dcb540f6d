// A frame between its numbers and its ranks: what the encoder and the decoder have in common.
#pragma once

#include <span>

#include "recording/component_loops.h"
#include "recording/prediction.h"
#include "recording/rank_blocks.h"

namespace ribbon {

// Keeps its memory between frames.
class FramePrediction {
 public:
  explicit FramePrediction(const CodecParameters& parameters);

  // Begins a frame. references: none of them plain; none at all: it is predicted within itself.
  void begin(Prediction prediction, std::span<const LatticeFrame* const> references);

  [[nodiscard]] Prediction prediction() const { return prediction_; }
  [[nodiscard]] const ParityPlanes& planes() const { return planes_; }
  [[nodiscard]] const Past& past() const { return past_; }
  // Values less those of the first frame referred to, by cell.
  PlaneFields<float>& motion() { return motion_; }

  Weights weights{};               // used unless the frame is predicted within itself
  WithinWeights within_weights{};  // used if it is

  // Makes the numbers and values of `frame` from ranks.
  void decode(Ranks& ranks, LatticeFrame& frame);
  // Makes the ranks of `frame`; before, motion() must be set, its borders included.
  void rank(LatticeFrame& frame, Ranks& ranks);

 private:
  Component component(std::size_t c, LatticeFrame& frame, Ranks& ranks);

  ParityPlanes planes_;
  float step_m_;
  Prediction prediction_ = Prediction::within;
  Past past_;
  LatticeFrame nothing_;  // all numbers and values 0
  PlaneFields<float> motion_;
  std::vector<float> missed_;
  std::vector<float> predicted_;
};

}  // namespace ribbon

// Values of a frame to residuals and back: what the encoder and the decoder have in common.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "recording/codec/codec_parameters.h"
#include "recording/codec/column_loops.h"
#include "recording/codec/prediction_weights.h"
#include "recording/codec/quantised_frame.h"
#include "recording/codec/residual_runs.h"

namespace ribbon {

class FramePrediction {
 public:
  explicit FramePrediction(const CodecParameters& parameters)
      : layout_(parameters.grid), uniform_(parameters.step_m > 0), no_motion_(layout_.cells()) {}

  // Begins a frame. references: the nearest first, of which two count, none of them plain, and all
  // live until the frame ends; none at all: it is an intra frame. The frame's values and motion get
  // their cells.
  void begin(std::span<const QuantisedFrame* const> references, QuantisedFrame& frame);
  // Makes the motion of a frame whose values are known.
  void set_motion();

  [[nodiscard]] bool is_intra() const { return references_[0] == nullptr; }
  [[nodiscard]] bool is_uniform() const { return uniform_; }
  [[nodiscard]] const ParticleColumns& layout() const { return layout_; }

  // Column j of x, y and z.
  [[nodiscard]] Triple<PredictedColumn> columns(int j, Residuals& residuals) const;

  RecordedWeights weights;  // unless it is an intra frame

  // Makes the values and the motion of the frame from residuals, borders included.
  void decode(Residuals& residuals);
  // Makes the residuals of the frame.
  void encode(Residuals& residuals) const;

 private:
  ParticleColumns layout_;
  bool uniform_;
  std::array<const QuantisedFrame*, 2> references_{};
  QuantisedFrame* frame_ = nullptr;
  Lines<float> no_motion_;  // of frames that there are not
};

// Continues values in straight lines over the border of a column.
void continue_over_ends(const ParticleColumns& columns, int j, CellValues& values);

}  // namespace ribbon

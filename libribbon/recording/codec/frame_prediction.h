// Values of a frame to residuals and back: what the encoder and the decoder have in common.
#pragma once

#include <array>
#include <cstdint>

#include "recording/codec/column_loops.h"
#include "recording/codec/quantised_frame.h"
#include "recording/codec/residual_runs.h"

namespace ribbon {

// Weights as they are recorded, in units: of the first column, which has none before it, and of all
// others.
using RecordedWeights = std::array<std::array<std::int16_t, most_taps>, 2>;
inline constexpr float weight_unit = 0x1p-13F;

class FramePrediction {
 public:
  explicit FramePrediction(const RibbonGrid& grid) : layout_(grid) {}

  // Begins a frame, which gets cells for its values and its motion. reference: what it is predicted
  // from, of the same step, which lives until the frame ends; none: it is an intra frame.
  void begin(const QuantisedFrame* reference, QuantisedFrame& frame);

  [[nodiscard]] bool is_intra() const { return reference_ == nullptr; }
  [[nodiscard]] bool is_uniform() const { return frame_->step_m > 0; }
  [[nodiscard]] const ParticleColumns& layout() const { return layout_; }

  // Column j of x, y and z.
  [[nodiscard]] Triple<PredictedColumn> columns(int j, Residuals& residuals) const;

  RecordedWeights weights{};  // unless it is an intra frame

  // Makes the values and the motion of the frame, borders included, from residuals, which are used
  // up.
  void decode(Residuals& residuals) { code(residuals, ribbon::decode); }
  // Makes the residuals of the frame, and its motion.
  void encode(Residuals& residuals) { code(residuals, ribbon::encode); }

 private:
  void code(Residuals& residuals, void (*column)(const PredictedColumn&, const Weights&));

  ParticleColumns layout_;
  const QuantisedFrame* reference_ = nullptr;
  QuantisedFrame* frame_ = nullptr;
};

// Continues values in straight lines over the ends of a column.
void continue_over_ends(const ParticleColumns& columns, int j, CellValues& values);

}  // namespace ribbon

#include "recording/frame_prediction.h"

namespace ribbon {

FramePrediction::FramePrediction(const CodecParameters& parameters)
    : planes_(parameters.grid), step_m_(parameters.step_m), past_(parameters) {
  for (std::size_t c = 0; c < 3; ++c) {
    nothing_.numbers[c].assign(planes_.cells(), 0);
    nothing_.values[c].assign(planes_.cells(), 0);
    motion_[c].assign(planes_.cells(), 0);
  }
  missed_.assign(planes_.cells(), 0);
  predicted_.assign(planes_.cells(), 0);
}

void FramePrediction::begin(Prediction prediction,
                            std::span<const LatticeFrame* const> references) {
  prediction_ = references.empty() ? Prediction::within : prediction;
  if (prediction_ != Prediction::within) past_.set(prediction_, references);
}

Component FramePrediction::component(std::size_t c, LatticeFrame& frame, Ranks& ranks) {
  const LatticeFrame& reference = prediction_ == Prediction::within ? nothing_ : past_.first();
  return {.planes = &planes_,
          .prediction = prediction_,
          .on_lattice = step_m_ > 0,
          .reference_values = reference.values[c].data(),
          .reference_numbers = reference.numbers[c].data(),
          .past = &past_.fields(c),
          .weights = &weights,
          .within_weights = &within_weights,
          .numbers = frame.numbers[c].data(),
          .values = frame.values[c].data(),
          .motion = motion_[c].data(),
          .missed = missed_.data(),
          .predicted = predicted_.data(),
          .ranks = ranks[c].data()};
}

void FramePrediction::decode(Ranks& ranks, LatticeFrame& frame) {
  for (std::size_t c = 0; c < 3; ++c) {
    frame.numbers[c].resize(planes_.cells());
    frame.values[c].resize(planes_.cells());
  }
  for (std::size_t c = 0; c < 3; ++c) loops().decode(component(c, frame, ranks));
  frame.continue_values();
}

void FramePrediction::rank(LatticeFrame& frame, Ranks& ranks) {
  for (auto& component_ranks : ranks) component_ranks.resize(room_for_ranks(planes_.grid()));
  for (std::size_t c = 0; c < 3; ++c) loops().rank(component(c, frame, ranks));
}

}  // namespace ribbon

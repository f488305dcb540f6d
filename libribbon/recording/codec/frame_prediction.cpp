#include "recording/codec/frame_prediction.h"

#include <cassert>

namespace ribbon {

namespace {

float over_squared(double length) {
  return 1.0F / static_cast<float>(length * length);
}

template <class Number>
Triple<Number*> pointers(PlaneFields<Number>& fields) {
  return {fields[0].data(), fields[1].data(), fields[2].data()};
}
template <class Number>
Triple<const Number*> pointers(const PlaneFields<Number>& fields) {
  return {fields[0].data(), fields[1].data(), fields[2].data()};
}

}  // namespace

FramePrediction::FramePrediction(const CodecParameters& parameters) : planes_(parameters.grid) {
  for (auto& component : motion_) component.assign(planes_.cells(), 0);
  const bool uniform = parameters.step_m > 0;
  const double unit_m = uniform ? static_cast<double>(parameters.step_m) : 1;
  frame_.uniform = uniform;
  frame_.over_along_rest_squared =
      over_squared(parameters.ribbon_length_m / (parameters.grid.along - 1) / unit_m);
  frame_.over_across_rest_squared =
      over_squared(parameters.ribbon_width_m / (parameters.grid.across - 1) / unit_m);
}

void FramePrediction::begin(Prediction prediction,
                            std::span<const QuantisedFrame* const> references) {
  assert(references.empty() || prediction != Prediction::intra);
  frame_.planes = &planes_;  // anew: the whole may have moved since
  frame_.prediction = references.empty() ? Prediction::intra : prediction;
  if (references.empty()) return;
  // For want of a second frame the first, of a third the second (P) or the first (B), of a fourth
  // the second.
  const std::array<std::size_t, 4> instead = {0, 0, prediction == Prediction::p ? 1U : 0U, 1};
  for (std::size_t k = 0; k < frame_.reference_values.size(); ++k)
    frame_.reference_values[k] = k < references.size() ? pointers(references[k]->values)
                                                       : frame_.reference_values[instead[k]];
}

void FramePrediction::set_fields(QuantisedFrame& frame) {
  frame_.weights = &weights;
  frame_.intra_weights = &intra_weights;
  frame_.values = pointers(frame.values);
  frame_.motion = pointers(motion_);
}

void FramePrediction::decode(Residuals& residuals, QuantisedFrame& frame) {
  for (auto& component : frame.values) component.resize(planes_.cells());
  set_fields(frame);
  frame_.residuals = pointers(residuals);
  loops().decode(frame_);
  frame.continue_values();
}

void FramePrediction::set(QuantisedFrame& frame) {
  set_fields(frame);
  loops().set_motion(frame_);
}

void FramePrediction::encode(Residuals& residuals) {
  for (auto& component : residuals) component.resize(planes_.cells());
  frame_.residuals = pointers(residuals);
  loops().encode(frame_);
}

}  // namespace ribbon

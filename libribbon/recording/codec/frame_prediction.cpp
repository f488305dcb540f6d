#include "recording/codec/frame_prediction.h"

#include <algorithm>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

float line(float near, float far) {
  return (near + near) - far;
}

void continue_beyond(const float* near, const float* far, int rows, float* to) {
  RIBBON_EACH_LANE
  for (int i = 0; i < rows; ++i) to[i] = line(near[i], far[i]);
}

void continue_over_sides(const ParticleColumns& columns, CellValues& values) {
  const int last = columns.grid().across - 1;
  const int rows = columns.grid().along;
  for (auto& component : values) {
    const auto column = [&](int j) { return &component[columns.cell(0, j)]; };
    continue_beyond(column(0), column(1), rows, column(-1));
    continue_beyond(column(last), column(last - 1), rows, column(last + 1));
  }
}

}  // namespace

void continue_over_ends(const ParticleColumns& columns, int j, CellValues& values) {
  const int rows = columns.grid().along;
  for (auto& component : values) {
    float* column = &component[columns.cell(0, j)];
    column[-1] = line(column[0], column[1]);
    column[rows] = line(column[rows - 1], column[rows - 2]);
  }
}

void FramePrediction::begin(const QuantisedFrame* reference, QuantisedFrame& frame) {
  reference_ = reference;
  frame_ = &frame;
  for (std::size_t c = 0; c < 3; ++c) {
    frame.values[c].resize(layout_.cells());
    frame.motion[c].resize(layout_.cells());
    // An intra frame has not moved, nor has what would be the column before the first.
    const auto still = is_intra() ? layout_.cells() : layout_.cell(0, 0);
    std::fill_n(frame.motion[c].begin(), still, 0.0F);
  }
}

Triple<PredictedColumn> FramePrediction::columns(int j, Residuals& residuals) const {
  const std::size_t cell = layout_.cell(0, j);
  Triple<PredictedColumn> columns;
  for (std::size_t c = 0; c < 3; ++c)
    columns[c] = {.rows = layout_.grid().along,
                  .stride = static_cast<std::ptrdiff_t>(layout_.stride()),
                  .is_first = j == 0,
                  .uniform = is_uniform(),
                  .past_values = is_intra() ? nullptr : &reference_->values[c][cell],
                  .past_motion = is_intra() ? nullptr : &reference_->motion[c][cell],
                  .values = &frame_->values[c][cell],
                  .motion = &frame_->motion[c][cell],
                  .residuals = residuals.column(c, j)};
  return columns;
}

void FramePrediction::code(Residuals& residuals,
                           void (*column)(const PredictedColumn&, const Weights&)) {
  for (int j = 0; j < layout_.grid().across; ++j) {
    Weights of_column;
    for (std::size_t tap = 0; tap < most_taps; ++tap)
      of_column[tap] = static_cast<float>(weights[j == 0 ? 0 : 1][tap]) * weight_unit;
    for (const PredictedColumn& component : columns(j, residuals)) column(component, of_column);
    continue_over_ends(layout_, j, frame_->values);
    continue_over_ends(layout_, j, frame_->motion);
  }
  continue_over_sides(layout_, frame_->motion);
}

}  // namespace ribbon

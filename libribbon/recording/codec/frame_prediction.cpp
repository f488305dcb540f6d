#include "recording/codec/frame_prediction.h"

#include <algorithm>
#include <functional>

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

// Over the border of all columns.
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

void FramePrediction::begin(std::span<const QuantisedFrame* const> references,
                            QuantisedFrame& frame) {
  references_ = {};
  std::copy_n(references.begin(), std::min(references.size(), references_.size()),
              references_.begin());
  frame_ = &frame;
  for (std::size_t c = 0; c < 3; ++c) {
    frame.values[c].resize(layout_.cells());
    frame.motion[c].resize(layout_.cells());
  }
}

void FramePrediction::set_motion() {
  for (std::size_t c = 0; c < 3; ++c) {
    Lines<float>& motion = frame_->motion[c];
    if (is_intra())
      std::fill(motion.begin(), motion.end(), 0.0F);
    else
      std::transform(frame_->values[c].begin(), frame_->values[c].end(),
                     references_[0]->values[c].begin(), motion.begin(), std::minus<>());
  }
  // As a decoder does it: the difference of continued values may be rounded otherwise.
  for (int j = 0; j < layout_.grid().across; ++j) continue_over_ends(layout_, j, frame_->motion);
  continue_over_sides(layout_, frame_->motion);
}

Triple<PredictedColumn> FramePrediction::columns(int j, Residuals& residuals) const {
  const std::size_t cell = layout_.cell(0, j);
  Triple<PredictedColumn> columns;
  for (std::size_t c = 0; c < 3; ++c) {
    columns[c] = {.rows = layout_.grid().along,
                  .stride = static_cast<std::ptrdiff_t>(layout_.stride()),
                  .is_first = j == 0,
                  .uniform = uniform_,
                  .values = &frame_->values[c][cell],
                  .motion = &frame_->motion[c][cell],
                  .residuals = residuals.column(c, j)};
    if (is_intra()) continue;
    columns[c].past_values = &references_[0]->values[c][cell];
    columns[c].past_motion = &references_[0]->motion[c][cell];
    columns[c].older_motion =
        references_[1] != nullptr ? &references_[1]->motion[c][cell] : &no_motion_[cell];
  }
  return columns;
}

void FramePrediction::decode(Residuals& residuals) {
  const Weights first = weights.of_first_column();
  const Weights others = weights.of_others();
  Triple<std::vector<std::int32_t>> numbers;
  for (auto& column : numbers) column.resize(is_intra() ? layout_.grid().along : 0);
  for (int j = 0; j < layout_.grid().across; ++j) {
    const auto at = columns(j, residuals);
    for (std::size_t c = 0; c < 3; ++c)
      if (is_intra())
        decode_intra(at[c], numbers[c].data());
      else
        ribbon::decode(at[c], j == 0 ? first : others);
    continue_over_ends(layout_, j, frame_->values);
    continue_over_ends(layout_, j, frame_->motion);
  }
  if (is_intra()) return set_motion();
  continue_over_sides(layout_, frame_->motion);
}

void FramePrediction::encode(Residuals& residuals) const {
  const Weights first = weights.of_first_column();
  const Weights others = weights.of_others();
  Triple<std::vector<std::int32_t>> numbers;
  for (auto& column : numbers) column.resize(is_intra() ? layout_.grid().along : 0);
  for (int j = 0; j < layout_.grid().across; ++j) {
    const auto at = columns(j, residuals);
    for (std::size_t c = 0; c < 3; ++c)
      if (is_intra())
        encode_intra(at[c], numbers[c].data());
      else
        ribbon::encode(at[c], j == 0 ? first : others);
  }
}

}  // namespace ribbon

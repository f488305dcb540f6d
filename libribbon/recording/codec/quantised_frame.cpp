#include "recording/codec/quantised_frame.h"

#include <algorithm>
#include <cmath>

namespace ribbon {

namespace {

// A few rows after the other, so that they stay at hand until they are complete.
constexpr int rows_at_a_time = 16;

void put_rows(const QuantisedFrame& frame, int begin, int end, Eigen::Matrix3Xf& positions) {
  const ParticleColumns columns(frame.grid);
  const float scale = frame.step_m > 0 ? frame.step_m : 1;
  for (int j = 0; j < frame.grid.across; ++j) {
    const std::size_t cell = columns.cell(begin, j);
    const Triple<const float*> values{&frame.values[0][cell], &frame.values[1][cell],
                                      &frame.values[2][cell]};
    float* position = positions.col(frame.grid.particle(begin, j)).data();
    const std::ptrdiff_t row_length = std::ptrdiff_t{3} * frame.grid.across;
    for (int k = 0; k < end - begin; ++k, position += row_length)
      for (std::size_t c = 0; c < 3; ++c) position[c] = values[c][k] * scale;
  }
}

}  // namespace

void QuantisedFrame::positions(Eigen::Matrix3Xf& positions) const {
  if (plain) {
    positions = plain_positions;
    return;
  }
  positions.resize(3, grid.particle_count());
  for (int row = 0; row < grid.along; row += rows_at_a_time)
    put_rows(*this, row, std::min(row + rows_at_a_time, grid.along), positions);
}

bool QuantisedFrame::is_finite() const {
  if (step_m > 0) return true;
  const ParticleColumns columns(grid);
  bool finite = true;
  for (const auto& component : values)
    for (int j = 0; j < grid.across; ++j)
      for (int i = 0; i < grid.along; ++i)
        finite = finite && std::isfinite(component[columns.cell(i, j)]);
  return finite;
}

std::span<const QuantisedFrame* const> usable(std::span<const QuantisedFrame* const> references) {
  std::size_t count = 0;
  while (count < references.size() && !references[count]->plain) ++count;
  return references.first(count);
}

}  // namespace ribbon

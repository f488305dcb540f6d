#include "recording/codec/quantised_frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace ribbon {

namespace {

using Four = float __attribute__((vector_size(16)));

[[gnu::always_inline]] inline Four scaled(const float* values, float scale) {
  Four four;
  std::memcpy(&four, values, sizeof(four));
  return four * scale;
}

// Of four rows of a column, from x, y and z apart to particles `row_length` apart. Each is written
// with a coordinate too many, where the next particle of its row begins.
[[gnu::always_inline]] inline void put_four(const Triple<const float*>& values, float scale,
                                            std::ptrdiff_t row_length, float* to) {
  const Four x = scaled(values[0], scale);
  const Four y = scaled(values[1], scale);
  const Four z = scaled(values[2], scale);
  const Four first = __builtin_shufflevector(x, y, 0, 4, 1, 5);
  const Four last = __builtin_shufflevector(x, y, 2, 6, 3, 7);
  for (const Four& row :
       {__builtin_shufflevector(first, z, 0, 1, 4, 4),
        __builtin_shufflevector(first, z, 2, 3, 5, 5), __builtin_shufflevector(last, z, 0, 1, 6, 6),
        __builtin_shufflevector(last, z, 2, 3, 7, 7)}) {
    std::memcpy(to, &row, sizeof(row));
    to += row_length;
  }
}

// A few rows after the other, so that they stay at hand until they are complete.
constexpr int rows_at_a_time = 16;

// Column by column: what one writes too many is overwritten by the next; the last writes no more
// than its own.
void put_rows(const QuantisedFrame& frame, int begin, int end, Eigen::Matrix3Xf& positions) {
  const ParticleColumns columns(frame.grid);
  const float scale = frame.step_m > 0 ? frame.step_m : 1;
  const std::ptrdiff_t row_length = std::ptrdiff_t{3} * frame.grid.across;
  for (int j = 0; j < frame.grid.across; ++j) {
    const std::size_t cell = columns.cell(begin, j);
    Triple<const float*> values{&frame.values[0][cell], &frame.values[1][cell],
                                &frame.values[2][cell]};
    float* position = positions.col(frame.grid.particle(begin, j)).data();
    int left = end - begin;
    for (; left >= 4 && j + 1 < frame.grid.across; left -= 4, position += 4 * row_length) {
      put_four(values, scale, row_length, position);
      for (const float*& component : values) component += 4;
    }
    for (int k = 0; k < left; ++k, position += row_length)
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

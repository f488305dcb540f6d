#include "recording/codec/quantised_frame.h"

#include <algorithm>
#include <cstddef>

namespace ribbon {

namespace {

// So many rows of so many columns are put together at a time.
constexpr int tile = 4;

// From columns of x, y and z, each `stride` from the next, to rows of coordinates that are
// `row_length` apart; four by four of them at a time.
void put_tile(const Triple<const float*>& from, std::size_t stride, float scale,
              std::ptrdiff_t row_length, float* to) {
  for (std::size_t run = 0; run < 3 * std::size_t{tile}; run += tile, to += tile) {
    Eigen::Matrix4f block;
    for (std::size_t k = 0; k < tile; ++k)
      block.col(static_cast<Eigen::Index>(k)) =
          Eigen::Vector4f::Map(from[(run + k) % 3] + (run + k) / 3 * stride);
    block.transposeInPlace();
    for (int row = 0; row < tile; ++row)
      Eigen::Vector4f::Map(to + row * row_length) = block.col(row) * scale;
  }
}

}  // namespace

void QuantisedFrame::positions(Eigen::Matrix3Xf& positions) const {
  positions.resize(3, grid.particle_count());
  const ParticleColumns columns(grid);
  const float scale = step_m > 0 ? step_m : 1;
  const auto put = [&](int i, int j) {
    for (std::size_t c = 0; c < 3; ++c)
      positions(static_cast<Eigen::Index>(c), grid.particle(i, j)) =
          values[c][columns.cell(i, j)] * scale;
  };
  for (int i = 0; i < grid.along; i += tile)
    for (int j = 0; j < grid.across; j += tile) {
      const std::size_t cell = columns.cell(i, j);
      if (i + tile <= grid.along && j + tile <= grid.across)
        put_tile({&values[0][cell], &values[1][cell], &values[2][cell]}, columns.stride(), scale,
                 std::ptrdiff_t{3} * grid.across, positions.col(grid.particle(i, j)).data());
      else
        for (int row = i; row < std::min(i + tile, grid.along); ++row)
          for (int column = j; column < std::min(j + tile, grid.across); ++column) put(row, column);
    }
}

}  // namespace ribbon

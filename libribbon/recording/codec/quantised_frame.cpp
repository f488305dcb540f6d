#include "recording/codec/quantised_frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

using Four = float __attribute__((vector_size(16)));

// The first two of both by turns: a0 b0 a1 b1.
[[gnu::always_inline]] inline Four first_of(const Four& a, const Four& b) {
  return __builtin_shufflevector(a, b, 0, 4, 1, 5);
}
// Likewise the last two.
[[gnu::always_inline]] inline Four last_of(const Four& a, const Four& b) {
  return __builtin_shufflevector(a, b, 2, 6, 3, 7);
}

// So many rows of so many columns are put together at a time.
constexpr int tile = 4;

// x, y and z of a particle, and how far they lie from those of the next column.
struct Coordinates {
  Triple<const float*> first;
  std::size_t stride;

  // Four rows of x, y or z in the first column (run 0, 1, 2), in the next (3, 4, 5), ...
  [[gnu::always_inline]] [[nodiscard]] Four scaled(std::size_t run, float scale) const {
    Four rows;
    std::memcpy(&rows, first[run % 3] + run / 3 * stride, sizeof(rows));
    return rows * scale;
  }
};

// From twelve runs to four rows of twelve coordinates, `row_length` apart; four of each at a time.
[[gnu::always_inline]] inline void put_tile(Coordinates from, float scale,
                                            std::ptrdiff_t row_length, float* to) {
  for (std::size_t run = 0; run < 3 * std::size_t{tile}; run += 4, to += 4) {
    const Four a = from.scaled(run, scale);
    const Four b = from.scaled(run + 1, scale);
    const Four c = from.scaled(run + 2, scale);
    const Four d = from.scaled(run + 3, scale);
    const std::array<Four, 4> pairs{first_of(a, b), first_of(c, d), last_of(a, b), last_of(c, d)};
    float* row = to;
    for (const Four& four : {__builtin_shufflevector(pairs[0], pairs[1], 0, 1, 4, 5),
                             __builtin_shufflevector(pairs[0], pairs[1], 2, 3, 6, 7),
                             __builtin_shufflevector(pairs[2], pairs[3], 0, 1, 4, 5),
                             __builtin_shufflevector(pairs[2], pairs[3], 2, 3, 6, 7)}) {
      std::memcpy(row, &four, sizeof(four));
      row += row_length;
    }
  }
}

}  // namespace

void QuantisedFrame::positions(Eigen::Matrix3Xf& positions) const {
  if (plain) {
    positions = plain_positions;
    return;
  }
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
        put_tile({{&values[0][cell], &values[1][cell], &values[2][cell]}, columns.stride()}, scale,
                 std::ptrdiff_t{3} * grid.across, positions.col(grid.particle(i, j)).data());
      else
        for (int row = i; row < std::min(i + tile, grid.along); ++row)
          for (int column = j; column < std::min(j + tile, grid.across); ++column) put(row, column);
    }
}

bool QuantisedFrame::is_finite() const {
  if (step_m > 0) return true;
  const ParticleColumns columns(grid);
  bool finite = true;
  vectorised([&]() RIBBON_INLINED {
    std::int32_t largest = 0;  // bits of a magnitude: ordered as magnitudes are
    const int rows = grid.along;
    for (const auto& component : values)
      for (int j = 0; j < grid.across; ++j) {
        const float* column = &component[columns.cell(0, j)];
        RIBBON_EACH_LANE
        for (int i = 0; i < rows; ++i)
          largest = std::max(largest, Eigen::numext::bit_cast<std::int32_t>(std::abs(column[i])));
      }
    finite = Eigen::numext::bit_cast<float>(largest) < std::numeric_limits<float>::infinity();
  });
  return finite;
}

std::span<const QuantisedFrame* const> usable(std::span<const QuantisedFrame* const> references) {
  std::size_t count = 0;
  while (count < references.size() && !references[count]->plain) ++count;
  return references.first(count);
}

}  // namespace ribbon

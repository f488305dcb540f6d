#include "recording/prediction.h"

#include <algorithm>

namespace ribbon {

namespace {

// The eight neighbours within a field, in the order of taps 10 to 17.
std::array<std::size_t, 8> neighbours(std::size_t at, std::size_t stride) {
  return {at - stride,     at + stride,     at - 1,          at + 1,
          at - stride - 1, at - stride + 1, at + stride - 1, at + stride + 1};
}

}  // namespace

void PaddedGrid::replicate_border(Field& field) const {
  for (int i = 0; i < along; ++i) {
    field[at(i, -1)] = field[at(i, 0)];
    field[at(i, across)] = field[at(i, across - 1)];
  }
  std::copy_n(field.begin() + stride, stride, field.begin());
  std::copy_n(field.end() - 2 * stride, stride, field.end() - stride);
}

Taps taps_from_past(const PaddedGrid& grid, const Past& past, const Field& change, std::size_t at) {
  const auto stride = static_cast<std::size_t>(grid.stride);
  const Field& motion = past.motion;
  Taps taps{motion[at],
            change[at - stride],
            change[at - 1],
            change[at - stride - 1],
            change[at - stride + 1],
            past.older_motion[at],
            motion[at - stride],
            motion[at + stride],
            motion[at - 1],
            motion[at + 1]};
  const auto around = neighbours(at, stride);
  for (std::size_t n = 0; n < around.size(); ++n)
    taps[10 + n] = wrapping_subtract(past.position[around[n]], past.position[at]);
  return taps;
}

Taps taps_from_rows(const PaddedGrid& grid, const Field& position, const Field& change,
                    std::size_t at) {
  const auto stride = static_cast<std::size_t>(grid.stride);
  const std::size_t above = at - stride;
  const std::size_t second = above - stride;
  return {change[at - 1],
          change[above],
          change[above - 1],
          change[above + 1],
          change[second],
          wrapping_subtract(position[above - 1], position[above]),
          wrapping_subtract(position[above + 1], position[above]),
          change[second - 1],
          change[second + 1]};
}

std::vector<std::uint32_t> weighted_past(const PaddedGrid& grid, const Past& past,
                                         const Predictor& predictor) {
  const auto& c = predictor.coefficients;
  const auto stride = static_cast<std::size_t>(grid.stride);
  // Neighbours count relative to the particle itself, which therefore gets minus their sum.
  std::uint32_t own = 0;
  for (int tap = 10; tap < past_taps; ++tap)
    own -= static_cast<std::uint32_t>(c[static_cast<std::size_t>(tap)]);
  std::vector<std::uint32_t> sums(grid.size());
  const Field& p = past.position;
  const Field& m = past.motion;
  for (std::size_t at = stride + 1; at + stride + 1 < sums.size(); ++at) {
    const auto around = neighbours(at, stride);
    std::uint32_t sum = own * static_cast<std::uint32_t>(p[at]) + wrapping_product(c[0], m[at]) +
                        wrapping_product(c[5], past.older_motion[at]);
    for (std::size_t n = 0; n < 4; ++n) sum += wrapping_product(c[6 + n], m[around[n]]);
    for (std::size_t n = 0; n < 8; ++n) sum += wrapping_product(c[10 + n], p[around[n]]);
    sums[at] = sum;
  }
  return sums;
}

std::uint32_t weighted_rows_above(const PaddedGrid& grid, const Field& position,
                                  const Field& change, std::size_t at, const Predictor& predictor) {
  const Taps taps = taps_from_rows(grid, position, change, at);
  std::uint32_t sum = 0;
  for (std::size_t tap = 1; tap < row_taps; ++tap)
    sum += wrapping_product(predictor.coefficients[tap], taps[tap]);
  return sum;
}

}  // namespace ribbon

// The predictor of positions, the same in the encoder and in every decoder: integer arithmetic
// modulo 2^32 throughout, so that no compiler and no processor can disagree (FORMAT.md, section 8).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// Finer than the quantisation step: what is predicted is not rounded to steps, which would cost
// up to a quarter of the size.
inline constexpr int units_per_step = 16;

// One component (x, y or z) of all particles in lattice units, with a border one particle wide, so
// that neighbours need no special cases.
using Field = std::vector<std::int32_t>;

struct PaddedGrid {
  int along = 0;
  int across = 0;
  std::ptrdiff_t stride = 0;  // from a row to the next

  explicit PaddedGrid(const RibbonGrid& grid)
      : along(grid.along), across(grid.across), stride(grid.across + 2) {}
  // -1 and along (across) are the border.
  [[nodiscard]] std::size_t at(int i, int j) const {
    return static_cast<std::size_t>((i + 1) * stride + j + 1);
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>((along + 2) * stride); }
  // Gives the border the values of its nearest particles.
  void replicate_border(Field& field) const;
};

// Visits the places of all particles, row by row.
template <class Visit>
void for_each_particle(const PaddedGrid& grid, Visit visit) {
  for (int i = 0; i < grid.along; ++i)
    for (std::size_t at = grid.at(i, 0); at < grid.at(i, grid.across); ++at) visit(at);
}

// What is known of one component when a delta frame comes.
struct Past {
  Field position;      // in the previous frame
  Field motion;        // from the frame before that to the previous one
  Field older_motion;  // one frame earlier
};

inline constexpr int past_taps = 18;  // from the previous frame
inline constexpr int row_taps = 9;    // from the row above

// What a prediction starts from and corrects by its taps.
enum class PredictionBase : std::uint8_t { row_above = 0, previous_frame = 1 };

// A linear prediction: the first `taps` taps, each times its coefficient, over 2^shift.
struct Predictor {
  PredictionBase base = PredictionBase::row_above;
  int taps = 0;
  int shift = 1;                                       // 1 to 30
  std::array<std::int32_t, past_taps> coefficients{};  // zero from `taps` on
};

// The taps of a particle, as many as the predictor could use. `change` is what is predicted: the
// motion since the previous frame or the step from the row above.
using Taps = std::array<std::int32_t, past_taps>;
Taps taps_from_past(const PaddedGrid& grid, const Past& past, const Field& change, std::size_t at);
Taps taps_from_rows(const PaddedGrid& grid, const Field& position, const Field& change,
                    std::size_t at);

// Rebuilds one component of a frame. residual(at, prediction) gives the number of steps to add to
// the prediction at a particle: a decoder has them, an encoder makes them. Calls go row by row.
// `change` is resized and filled as described at taps_from_past.
template <class Residual>
void rebuild_from_past(const PaddedGrid& grid, const Past& past, const Predictor& predictor,
                       Residual residual, Field& position, Field& change);
template <class Residual>
void rebuild_from_rows(const PaddedGrid& grid, const Predictor& predictor, Residual residual,
                       Field& position, Field& change);

// Details of the templates.

// Sums and products wrap around; a wrapped product is harmless where the whole sum fits.
inline std::int32_t wrapping_add(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
inline std::int32_t wrapping_subtract(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
inline std::uint32_t wrapping_product(std::int32_t a, std::int32_t b) {
  return static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b);
}

// The weighted sum of all taps that do not depend on this frame, for all particles at once.
std::vector<std::uint32_t> weighted_past(const PaddedGrid& grid, const Past& past,
                                         const Predictor& predictor);
// The weighted sum of all taps from the rows above, all but the first.
std::uint32_t weighted_rows_above(const PaddedGrid& grid, const Field& position,
                                  const Field& change, std::size_t at, const Predictor& predictor);

inline std::int32_t rounded_shift(std::uint32_t sum, int shift) {
  return static_cast<std::int32_t>(sum + (std::uint32_t{1} << (shift - 1))) >> shift;
}

// The border of row i of `change`, before and after the row itself is known.
inline void open_row(const PaddedGrid& grid, int i, Field& change) {
  change[grid.at(i, -1)] = change[grid.at(i - 1, 0)];
}
inline void close_row(const PaddedGrid& grid, int i, Field& change) {
  change[grid.at(i, -1)] = change[grid.at(i, 0)];
  change[grid.at(i, grid.across)] = change[grid.at(i, grid.across - 1)];
}

template <class Residual>
void rebuild_from_past(const PaddedGrid& grid, const Past& past, const Predictor& predictor,
                       Residual residual, Field& position, Field& change) {
  position.resize(grid.size());
  change.assign(grid.size(), 0);
  const std::vector<std::uint32_t> sums = weighted_past(grid, past, predictor);
  const auto& c = predictor.coefficients;
  const auto stride = static_cast<std::size_t>(grid.stride);
  for (int i = 0; i < grid.along; ++i) {
    open_row(grid, i, change);
    for (std::size_t at = grid.at(i, 0); at < grid.at(i, grid.across); ++at) {
      const std::size_t above = at - stride;
      const std::uint32_t sum = sums[at] + wrapping_product(c[1], change[above]) +
                                wrapping_product(c[2], change[at - 1]) +
                                wrapping_product(c[3], change[above - 1]) +
                                wrapping_product(c[4], change[above + 1]);
      const std::int32_t prediction =
          wrapping_add(past.position[at], rounded_shift(sum, predictor.shift));
      position[at] = wrapping_add(prediction, static_cast<std::int32_t>(wrapping_product(
                                                  units_per_step, residual(at, prediction))));
      change[at] = wrapping_subtract(position[at], past.position[at]);
    }
    close_row(grid, i, change);
  }
}

template <class Residual>
void rebuild_from_rows(const PaddedGrid& grid, const Predictor& predictor, Residual residual,
                       Field& position, Field& change) {
  position.assign(grid.size(), 0);
  change.assign(grid.size(), 0);
  const auto stride = static_cast<std::size_t>(grid.stride);
  const auto rebuild = [&](std::size_t at, std::int32_t prediction) {
    position[at] = wrapping_add(prediction, static_cast<std::int32_t>(wrapping_product(
                                                units_per_step, residual(at, prediction))));
  };
  for (std::size_t at = grid.at(0, 0); at < grid.at(0, grid.across); ++at)
    rebuild(at, position[at - 1]);
  for (int i = 1; i < grid.along; ++i) {
    close_row(grid, i - 1, position);
    open_row(grid, i, change);
    for (std::size_t at = grid.at(i, 0); at < grid.at(i, grid.across); ++at) {
      const std::uint32_t sum = weighted_rows_above(grid, position, change, at, predictor) +
                                wrapping_product(predictor.coefficients[0], change[at - 1]);
      rebuild(at, wrapping_add(position[at - stride], rounded_shift(sum, predictor.shift)));
      change[at] = wrapping_subtract(position[at], position[at - stride]);
    }
    close_row(grid, i, change);
  }
}

}  // namespace ribbon

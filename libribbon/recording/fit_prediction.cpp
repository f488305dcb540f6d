#include "recording/fit_prediction.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ribbon {

namespace {

constexpr std::size_t taps_max = delta_taps;
using Row = std::array<double, taps_max + 1>;  // the last column belongs to the wanted value
using Normal = std::array<Row, taps_max + 1>;

Normal normal_equations(const std::vector<Sample>& samples) {
  Normal sums{};
  for (const Sample& sample : samples) {
    Row row{};
    std::copy(sample.taps.begin(), sample.taps.end(), row.begin());
    row[taps_max] = sample.wanted;
    for (std::size_t a = 0; a <= taps_max; ++a)
      for (std::size_t b = a; b <= taps_max; ++b) sums[a][b] += row[a] * row[b];
  }
  return sums;
}

// U^T U = the matrix of the taps, U upper triangular; the last column of U becomes U^-T times the
// right-hand side. Both hold for every leading part of it, so one factorisation serves all tap
// counts.
void factorise(Normal& normal, std::size_t sample_count) {
  // Taps that are all zero, or copies of others, must not divide by zero: as if each tap carried
  // noise of half a lattice unit.
  const double noise = 0.25 * static_cast<double>(sample_count) + 1;
  for (std::size_t a = 0; a < taps_max; ++a) {
    double diagonal = normal[a][a] * (1 + 1e-9) + noise;
    for (std::size_t k = 0; k < a; ++k) diagonal -= normal[k][a] * normal[k][a];
    const double root = std::sqrt(std::max(diagonal, 0.5 * noise));
    normal[a][a] = root;
    for (std::size_t b = a + 1; b <= taps_max; ++b) {
      double sum = normal[a][b];
      for (std::size_t k = 0; k < a; ++k) sum -= normal[k][a] * normal[k][b];
      normal[a][b] = sum / root;
    }
  }
}

Row solve(const Normal& factor, std::size_t taps) {
  Row solution{};
  for (std::size_t a = taps; a-- > 0;) {
    double sum = factor[a][taps_max];
    for (std::size_t b = a + 1; b < taps; ++b) sum -= factor[a][b] * solution[b];
    solution[a] = sum / factor[a][a];
  }
  return solution;
}

// Rough size of the frame's residuals and coefficients: Gaussian residuals of this mean square.
double estimated_bits(double squared_error, std::size_t sample_count, int particles, int taps) {
  constexpr double squared_step = units_per_step * units_per_step;
  const double variance =
      std::max(squared_error, 0.0) / static_cast<double>(sample_count) / squared_step;
  return 0.5 * std::log2(variance + 1.0 / 12) * particles + 14.0 * taps;
}

// As fine as possible while the weighted sum, a little more than the largest wanted value, fits
// into 31 bits.
int shift_for(const std::vector<Sample>& samples) {
  std::uint32_t largest = 1;
  for (const Sample& sample : samples)
    largest = std::max(largest, static_cast<std::uint32_t>(std::abs(std::int64_t{sample.wanted})));
  return std::clamp(28 - static_cast<int>(std::bit_width(largest)), 4, 13);
}

Predictor rounded(const Row& solution, int taps, int shift) {
  constexpr double limit = 1 << 29;
  Predictor predictor{taps, shift, {}};
  for (std::size_t a = 0; a < static_cast<std::size_t>(taps); ++a)
    predictor.coefficients[a] = static_cast<std::int32_t>(
        std::clamp(std::floor(std::ldexp(solution[a], shift) + 0.5), -limit, limit));
  return predictor;
}

}  // namespace

Predictor fit_predictor(const std::vector<Sample>& samples, std::span<const int> choices,
                        int particles) {
  if (samples.empty()) return {};
  Normal normal = normal_equations(samples);
  double squared_error = normal[taps_max][taps_max];
  factorise(normal, samples.size());
  double fewest_bits = estimated_bits(squared_error, samples.size(), particles, 0);
  int best = 0;
  std::size_t done = 0;
  for (const int taps : choices) {
    for (; done < static_cast<std::size_t>(taps); ++done)
      squared_error -= normal[done][taps_max] * normal[done][taps_max];
    const double bits = estimated_bits(squared_error, samples.size(), particles, taps);
    if (bits < fewest_bits) {
      fewest_bits = bits;
      best = taps;
    }
  }
  return rounded(solve(normal, static_cast<std::size_t>(best)), best, shift_for(samples));
}

}  // namespace ribbon

#include "recording/fit_prediction.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ribbon {

namespace {

constexpr std::size_t taps_max = past_taps;
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

// Base-2 logarithm, linear between powers of two: exact arithmetic, so all machines choose alike.
double rough_log2(std::uint32_t number) {
  const int whole = static_cast<int>(std::bit_width(number)) - 1;
  return whole - 1 + static_cast<double>(number) / static_cast<double>(std::uint32_t{1} << whole);
}

// Rough size of a frame's residuals and coefficients, from how far the prediction is off at the
// samples. A sum of logarithms, not of squares: restless places are packed apart from calm ones.
double estimated_bits(const std::vector<Sample>& samples, const Predictor& predictor,
                      int particles) {
  double bits = 0;
  for (const Sample& sample : samples) {
    std::uint32_t sum = 0;
    for (std::size_t tap = 0; tap < static_cast<std::size_t>(predictor.taps); ++tap)
      sum += wrapping_product(predictor.coefficients[tap], sample.taps[tap]);
    const std::int64_t off = std::int64_t{sample.wanted} - rounded_shift(sum, predictor.shift);
    bits += rough_log2(static_cast<std::uint32_t>(
        units_per_step + std::min<std::int64_t>(2 * std::abs(off), 1 << 30)));
  }
  return bits / static_cast<double>(samples.size()) * particles + 14.0 * predictor.taps;
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
  Predictor predictor;
  predictor.taps = taps;
  predictor.shift = shift;
  for (std::size_t a = 0; a < static_cast<std::size_t>(taps); ++a)
    predictor.coefficients[a] = static_cast<std::int32_t>(
        std::clamp(std::floor(std::ldexp(solution[a], shift) + 0.5), -limit, limit));
  return predictor;
}

}  // namespace

Fit fit_predictor(const std::vector<Sample>& samples, std::span<const int> choices, int particles) {
  if (samples.empty()) return {};
  Normal normal = normal_equations(samples);
  factorise(normal, samples.size());
  const int shift = shift_for(samples);
  Fit best;
  best.bits = estimated_bits(samples, best.predictor, particles);
  for (const int taps : choices) {
    const Predictor predictor = rounded(solve(normal, static_cast<std::size_t>(taps)), taps, shift);
    const double bits = estimated_bits(samples, predictor, particles);
    if (bits < best.bits) best = {predictor, bits};
  }
  return best;
}

}  // namespace ribbon

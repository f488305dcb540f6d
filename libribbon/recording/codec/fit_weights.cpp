#include "recording/codec/fit_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

// So many groups of rows are enough to fit nine weights.
constexpr int most_groups = 200;

constexpr std::size_t terms = most_taps + 1;

// Sums of products of taps, and of taps with the motion that they should add up to, which comes
// last: each with those that do not come before it.
class NormalEquations {
 public:
  // Restless rows count less: they are hard to predict whatever the weights are. unit: a change of
  // motion from neighbour to neighbour that halves the weight's root.
  void add(const Taps& taps, float unit) {
    vectorised([&]() RIBBON_INLINED {
      Lanes calm{};
      for (int k = 0; k < tap_rows; ++k) calm[k] = calmness(taps, k, unit);
      for (std::size_t a = 0; a < terms; ++a) {
        Lanes weighed{};
        for (int k = 0; k < tap_rows; ++k) weighed[k] = taps[a][k] * calm[k];
        for (std::size_t b = a; b < terms; ++b)
          for (int k = 0; k < tap_rows; ++k) lanes_[a][b][k] += weighed[k] * taps[b][k];
      }
    });
    if (++groups_in_lanes_ == most_in_lanes) flush();
  }

  // The weights of the taps, by Cholesky's factorisation. Taps that are all zero, or copies of
  // others, must not divide by zero: as if each carried a little noise.
  std::array<double, most_taps> solution() {
    flush();
    const double noise = 1e-9 * sums_[most_taps][most_taps] + 1e-30;
    for (std::size_t a = 0; a < most_taps; ++a) {
      double diagonal = sums_[a][a] * (1 + 1e-7) + noise;
      for (std::size_t k = 0; k < a; ++k) diagonal -= sums_[k][a] * sums_[k][a];
      sums_[a][a] = std::sqrt(std::max(diagonal, 0.5 * noise));
      for (std::size_t b = a + 1; b < terms; ++b) {
        for (std::size_t k = 0; k < a; ++k) sums_[a][b] -= sums_[k][a] * sums_[k][b];
        sums_[a][b] /= sums_[a][a];
      }
    }
    std::array<double, most_taps> solved{};
    for (std::size_t a = most_taps; a-- > 0;) {
      double sum = sums_[a][most_taps];
      for (std::size_t b = a + 1; b < most_taps; ++b) sum -= sums_[a][b] * solved[b];
      solved[a] = sum / sums_[a][a];
    }
    // Numbers whose squares do not fit, or infinite differences: then there are no weights.
    const auto is_finite = [](double weight) { return std::isfinite(weight); };
    if (!std::all_of(solved.begin(), solved.end(), is_finite)) solved.fill(0);
    return solved;
  }

 private:
  using Lanes = std::array<float, tap_rows>;

  // More would be rounded too much in single precision.
  static constexpr int most_in_lanes = 16;

  [[gnu::always_inline]] static float calmness(const Taps& taps, int k, float unit) {
    float change = 0;
    for (std::size_t tap = 1; tap < 5; ++tap) change += std::abs(taps[tap][k] - taps[0][k]);
    const float root = 1 / (1 + change / unit);
    return root * root;
  }

  void flush() {
    for (std::size_t a = 0; a < terms; ++a)
      for (std::size_t b = a; b < terms; ++b)
        for (float& lane : lanes_[a][b]) sums_[a][b] += static_cast<double>(lane);
    lanes_ = {};
    groups_in_lanes_ = 0;
  }

  int groups_in_lanes_ = 0;
  std::array<std::array<Lanes, terms>, terms> lanes_{};
  std::array<std::array<double, terms>, terms> sums_{};
};

// A quantisation step, and without one a part of the coordinates themselves, as their rounding is.
float restless_change(const FramePrediction& prediction, Residuals& residuals) {
  if (prediction.is_uniform()) return 1;
  float size = 1e-30F;
  for (const PredictedColumn& column : prediction.columns(0, residuals))
    size = std::max(size, std::abs(column.past_values[0]));
  return size * 0x1p-18F;
}

// Some groups of rows of the columns from `begin` to before `end`, evenly spread.
NormalEquations equations_of(const FramePrediction& prediction, Residuals& residuals, int begin,
                             int end) {
  const float unit = restless_change(prediction, residuals);
  const int in_column = (prediction.layout().grid().along + tap_rows - 1) / tap_rows;
  const int groups = 3 * (end - begin) * in_column;
  const int wanted = std::min(groups, most_groups);
  NormalEquations equations;
  Taps taps;
  for (int k = 0; k < wanted; ++k) {
    const auto group = static_cast<int>(std::int64_t{k} * groups / wanted);
    const int column = group / in_column;
    const auto columns = prediction.columns(begin + column / 3, residuals);
    set_taps(columns[static_cast<std::size_t>(column % 3)], tap_rows * (group % in_column), taps);
    equations.add(taps, unit);
  }
  return equations;
}

}  // namespace

RecordedWeights fit_weights(const FramePrediction& prediction, Residuals& residuals) {
  const int across = prediction.layout().grid().across;
  const std::array solved{equations_of(prediction, residuals, 0, 1).solution(),
                          equations_of(prediction, residuals, 1, across).solution()};
  constexpr double limit = std::numeric_limits<std::int16_t>::max();
  RecordedWeights weights;
  for (std::size_t k = 0; k < solved.size(); ++k)
    for (std::size_t tap = 0; tap < most_taps; ++tap)
      weights[k][tap] = static_cast<std::int16_t>(
          std::clamp(std::floor(solved[k][tap] / weight_unit + 0.5), -limit, limit));
  return weights;
}

}  // namespace ribbon

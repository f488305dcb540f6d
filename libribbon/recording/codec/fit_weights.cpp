#include "recording/codec/fit_weights.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "parallel/vector_loop.h"

namespace ribbon {

namespace {

// So many groups of rows are enough to fit ten weights.
constexpr int most_groups = 400;

constexpr std::size_t fields = most_taps + 1;

// Sums of products of taps, and of taps with the motion that they should add up to, which comes
// last: each with those that do not come before it.
class NormalEquations {
 public:
  // Of the first `taps` taps alone.
  explicit NormalEquations(std::size_t taps) : taps_(taps) {}

  // Restless rows count less: they are hard to predict whatever the weights are. unit: a change of
  // motion from neighbour to neighbour that halves the weight's root.
  void add(const Taps& taps, float unit) {
    vectorised([&]() RIBBON_INLINED {
      Lanes calm{};
      for (int k = 0; k < tap_rows; ++k) calm[k] = calmness(taps, k, unit);
      for (std::size_t a = 0; a < fields; ++a) {
        Lanes weighed{};
        for (int k = 0; k < tap_rows; ++k) weighed[k] = taps[a][k] * calm[k];
        for (std::size_t b = a; b < fields; ++b)
          for (int k = 0; k < tap_rows; ++k) lanes_[a][b][k] += weighed[k] * taps[b][k];
      }
    });
    if (++groups_in_lanes_ == most_in_lanes) flush();
  }

  // The weights of the taps, by Cholesky's factorisation. Taps that are all zero, or copies of
  // others, must not divide by zero: as if each carried a little noise.
  std::array<double, most_taps> solution() {
    flush();
    wanted_ = sums_[most_taps][most_taps];
    const double noise = 1e-9 * wanted_ + 1e-30;
    for (std::size_t a = 0; a < taps_; ++a) {
      double diagonal = sums_[a][a] * (1 + 1e-7) + noise;
      for (std::size_t k = 0; k < a; ++k) diagonal -= sums_[k][a] * sums_[k][a];
      sums_[a][a] = std::sqrt(std::max(diagonal, 0.5 * noise));
      for (std::size_t b = a + 1; b < taps_; ++b) eliminate(a, b);
      eliminate(a, most_taps);
    }
    std::array<double, most_taps> solved{};
    for (std::size_t a = taps_; a-- > 0;) {
      double sum = sums_[a][most_taps];
      for (std::size_t b = a + 1; b < taps_; ++b) sum -= sums_[a][b] * solved[b];
      solved[a] = sum / sums_[a][a];
    }
    // Numbers whose squares do not fit, or infinite differences: then there are no weights.
    const auto is_finite = [](double weight) { return std::isfinite(weight); };
    if (!std::all_of(solved.begin(), solved.end(), is_finite)) solved.fill(0);
    return solved;
  }

  // Fine enough that rounded weights add a tenth to what the prediction misses. After solution().
  [[nodiscard]] int shift() const {
    double left = wanted_;
    for (std::size_t a = 0; a < taps_; ++a) left -= sums_[a][most_taps] * sums_[a][most_taps];
    const double ratio = std::sqrt(wanted_ / std::max(left, 1e-18 * wanted_ + 1e-30));
    return std::clamp(static_cast<int>(std::ilogb(ratio > 1 ? ratio : 1.0)) + 6, 6, 20);
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
    for (std::size_t a = 0; a < fields; ++a)
      for (std::size_t b = a; b < fields; ++b)
        for (float& lane : lanes_[a][b]) sums_[a][b] += static_cast<double>(lane);
    lanes_ = {};
    groups_in_lanes_ = 0;
  }

  void eliminate(std::size_t a, std::size_t b) {
    double sum = sums_[a][b];
    for (std::size_t k = 0; k < a; ++k) sum -= sums_[k][a] * sums_[k][b];
    sums_[a][b] = sum / sums_[a][a];
  }

  std::size_t taps_;
  int groups_in_lanes_ = 0;
  std::array<std::array<Lanes, fields>, fields> lanes_{};
  std::array<std::array<double, fields>, fields> sums_{};
  double wanted_ = 0;
};

class WeightFit {
 public:
  WeightFit(const FramePrediction& prediction, Residuals& residuals)
      : prediction_(prediction), residuals_(residuals) {
    if (!prediction.is_uniform()) unit_ = mean_change();
  }

  [[nodiscard]] RecordedWeights run() const {
    NormalEquations of_first(past_taps);
    NormalEquations of_others(most_taps);
    add_columns(0, 1, of_first);
    add_columns(1, grid().across, of_others);
    const auto first = of_first.solution();
    const auto others = of_others.solution();
    RecordedWeights fitted;
    fitted.shift = of_others.shift();
    for (std::size_t tap = 0; tap < past_taps; ++tap)
      fitted.first[tap] = rounded(first[tap], fitted.shift);
    for (std::size_t tap = 0; tap < most_taps; ++tap)
      fitted.others[tap] = rounded(others[tap], fitted.shift);
    return fitted;
  }

 private:
  [[nodiscard]] const RibbonGrid& grid() const { return prediction_.layout().grid(); }

  // Some groups of rows of these columns, evenly spread.
  void add_columns(int begin, int end, NormalEquations& equations) const {
    const int in_column = (grid().along + tap_rows - 1) / tap_rows;
    const int groups = 3 * (end - begin) * in_column;
    const int wanted = std::min(groups, most_groups);
    Taps taps;
    for (int k = 0; k < wanted; ++k) {
      const auto group = static_cast<int>(std::int64_t{k} * groups / wanted);
      const int column = group / in_column;
      const auto columns = prediction_.columns(begin + column / 3, residuals_);
      set_taps(columns[static_cast<std::size_t>(column % 3)], tap_rows * (group % in_column), taps);
      equations.add(taps, unit_);
    }
  }

  static std::int32_t rounded(double weight, int shift) {
    constexpr double limit = 1 << 24;
    return static_cast<std::int32_t>(
        std::clamp(std::floor(std::ldexp(weight, shift) + 0.5), -limit, limit));
  }

  // Without a quantisation step nothing else tells what restless is.
  [[nodiscard]] float mean_change() const {
    double sum = 0;
    for (const PredictedColumn& column : prediction_.columns(grid().across / 2, residuals_))
      for (int row = 0; row < column.rows; ++row)
        for (const int neighbour : {-1, 1})
          sum += std::abs(static_cast<double>(column.past_motion[row + neighbour]) -
                          static_cast<double>(column.past_motion[row]));
    const double mean = sum / (3.0 * grid().along);
    return static_cast<float>(std::clamp(2 * mean, 1e-30, 1e30));
  }

  const FramePrediction& prediction_;
  Residuals& residuals_;
  float unit_ = 1;  // of steps
};

}  // namespace

RecordedWeights fit_weights(const FramePrediction& prediction, Residuals& residuals) {
  return WeightFit(prediction, residuals).run();
}

}  // namespace ribbon

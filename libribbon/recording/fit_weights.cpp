#include "recording/fit_weights.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>

namespace ribbon {

namespace {

constexpr std::size_t quick_samples_per_stage = 800;

// Sums of products of taps, and of taps with the wanted value, which comes last.
class NormalEquations {
 public:
  explicit NormalEquations(std::size_t taps) : taps_(taps) {}

  // row: the taps, then the wanted value.
  void add(const std::array<double, most_taps + 1>& row, double weight) {
    for (std::size_t a = 0; a <= taps_; ++a) {
      const double weighted = weight * row[a];
      for (std::size_t b = 0; b <= taps_; ++b) sums_[a][b] += weighted * row[b];
    }
    total_ += weight;
  }

  // The weights of the taps, by Cholesky's factorisation. Taps that are all zero, or copies of
  // others, must not divide by zero: as if each carried a little noise.
  std::array<double, most_taps> solution() {
    for (std::size_t a = 0; a < taps_; ++a) {
      double diagonal = sums_[a][a] * (1 + 1e-7) + noise();
      for (std::size_t k = 0; k < a; ++k) diagonal -= sums_[k][a] * sums_[k][a];
      const double root = std::sqrt(std::max(diagonal, 0.5 * noise()));
      sums_[a][a] = root;
      for (std::size_t b = a + 1; b <= taps_; ++b) {
        double sum = sums_[a][b];
        for (std::size_t k = 0; k < a; ++k) sum -= sums_[k][a] * sums_[k][b];
        sums_[a][b] = sum / root;
      }
    }
    std::array<double, most_taps> solved{};
    for (std::size_t a = taps_; a-- > 0;) {
      double sum = sums_[a][taps_];
      for (std::size_t b = a + 1; b < taps_; ++b) sum -= sums_[a][b] * solved[b];
      solved[a] = sum / sums_[a][a];
    }
    // Numbers whose squares do not fit, or infinite differences: then there are no weights.
    if (!std::all_of(solved.begin(), solved.end(), [](double w) { return std::isfinite(w); }))
      solved.fill(0);
    return solved;
  }

  // What is left of the wanted values' squares, per weight; after solution().
  [[nodiscard]] double mean_square_left() const {
    double left = sums_[taps_][taps_];
    for (std::size_t a = 0; a < taps_; ++a) left -= sums_[a][taps_] * sums_[a][taps_];
    return std::max(left, 0.0) / std::max(total_, 1e-300);
  }
  [[nodiscard]] double mean_square_wanted() const {
    return sums_[taps_][taps_] / std::max(total_, 1e-300);
  }

 private:
  [[nodiscard]] double noise() const { return 1e-9 * sums_[taps_][taps_] + 1e-30; }

  std::size_t taps_;
  double total_ = 0;
  std::array<std::array<double, most_taps + 1>, most_taps + 1> sums_{};
};

using Row = std::array<double, most_taps + 1>;

class WeightFit {
 public:
  WeightFit(const ParityPlanes& planes, const Past& past, Prediction prediction,
            const PlaneFields<float>& motion, Fit fit)
      : planes_(planes),
        past_(past),
        prediction_(prediction),
        motion_(motion),
        samples_per_stage_(fit == Fit::quick ? quick_samples_per_stage : planes.cells()) {
    if (past.first().step_m == 0) unit_ = mean_change();
  }

  RecordedWeights run() {
    for (std::size_t stage = 0; stage < prediction_stage_count; ++stage) fit_stage(stage);
    return fitted_;
  }

 private:
  void fit_stage(std::size_t stage) {
    const std::size_t taps = (has_near_taps(stage) ? near_taps : 0) +
                             (has_past_taps(stage) ? past_taps_of(prediction_) : 0);
    NormalEquations equations(taps);
    for_each_sample(stage, [&](int plane, std::size_t cell) {
      const double weight = calmness(plane, cell);
      for (std::size_t c = 0; c < 3; ++c) equations.add(row_of(stage, plane, cell, c), weight);
    });
    const std::size_t first = has_near_taps(stage) ? 0 : near_taps;
    const auto solved = equations.solution();
    if (stage == coarse_past) choose_shift(equations);
    constexpr double limit = 1 << 24;
    for (std::size_t tap = 0; tap < taps; ++tap)
      fitted_.numbers[stage][first + tap] = static_cast<std::int32_t>(
          std::clamp(std::floor(std::ldexp(solved[tap], fitted_.shift) + 0.5), -limit, limit));
    if (stage == coarse_past) weights_ = fitted_.weights();
  }

  // Fine enough that rounded weights add a tenth to what the prediction misses.
  void choose_shift(const NormalEquations& equations) {
    const double ratio =
        std::sqrt(equations.mean_square_wanted() / std::max(equations.mean_square_left(), 1e-30));
    fitted_.shift =
        std::clamp(static_cast<int>(std::ilogb(ratio > 1 ? std::min(ratio, 1e9) : 1.0)) + 6, 6, 20);
  }

  // Evenly spread over the rows of the stage's planes, and over all columns.
  template <class Visit>
  void for_each_sample(std::size_t stage, Visit visit) const {
    if (stage == diagonal) return for_each_sample_of(3, samples_per_stage_, visit);
    if (stage == cross) {
      for_each_sample_of(1, samples_per_stage_ / 2, visit);
      return for_each_sample_of(2, samples_per_stage_ / 2, visit);
    }
    if (stage == coarse_past) return for_each_sample_of(0, samples_per_stage_, visit);
    for_each_sample_of(0, 2 * samples_per_stage_, [&](int plane, std::size_t cell, int a, int b) {
      const bool is_diagonal = a % 2 == 1 && b % 2 == 1;
      const bool is_cross = (a + b) % 2 == 1;
      if (stage == coarse_diagonal ? is_diagonal : is_cross) visit(plane, cell);
    });
  }

  template <class Visit>
  void for_each_sample_of(int plane, std::size_t wanted, Visit visit) const {
    const std::size_t count = planes_.particles(plane);
    const auto columns = static_cast<std::size_t>(planes_.columns(plane));
    std::size_t spacing = std::max<std::size_t>(1, count / wanted);
    while (spacing > 1 && spacing % 2 == 0) ++spacing;
    for (std::size_t at = 0; at < count; at += spacing) {
      const int a = static_cast<int>(at / columns);
      const int b = static_cast<int>(at % columns);
      if constexpr (std::is_invocable_v<Visit, int, std::size_t, int, int>)
        visit(plane, planes_.cell(plane, a, b), a, b);
      else
        visit(plane, planes_.cell(plane, a, b));
    }
  }

  // Restless particles are hard to predict whatever the weights are.
  [[nodiscard]] double calmness(int plane, std::size_t cell) const {
    const double restless = (2 * change_at(cell) + change_at(cell + planes_.step(plane, -1, 0)) +
                             change_at(cell + planes_.step(plane, 1, 0)) +
                             change_at(cell + planes_.step(plane, 0, -1)) +
                             change_at(cell + planes_.step(plane, 0, 1))) /
                            unit_;
    return 1 / ((1 + restless) * (1 + restless));
  }

  // Without a lattice there is no step that would tell what restless is.
  [[nodiscard]] double mean_change() const {
    double sum = 0;
    double count = 0;
    for_each_sample(coarse_past, [&](int, std::size_t cell) {
      sum += change_at(cell);
      ++count;
    });
    return sum / count + 1e-30;
  }

  [[nodiscard]] double change_at(std::size_t cell) const {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const PastFields& past = past_.fields(c);
      const float other =
          prediction_ == Prediction::between ? past.third_motion[cell] : past.motion[cell];
      sum += std::abs(static_cast<double>(other) - static_cast<double>(past.second_motion[cell]));
    }
    return sum / 3;
  }

  [[nodiscard]] Row row_of(std::size_t stage, int plane, std::size_t cell, std::size_t c) const {
    Row row{};
    std::size_t taps = 0;
    const float* motion = motion_[c].data() + cell;
    if (stage == coarse_diagonal || stage == coarse_cross) {
      const std::ptrdiff_t down = planes_.stride();
      const std::array<std::ptrdiff_t, near_taps> steps =
          stage == coarse_diagonal ? std::array{-down - 1, -down + 1, down - 1, down + 1}
                                   : std::array{-down, down, std::ptrdiff_t{-1}, std::ptrdiff_t{1}};
      for (const std::ptrdiff_t step : steps) row[taps++] = missed(cell + step, c);
      row[taps] = missed(cell, c);
      return row;
    }
    if (stage == diagonal)
      for (const auto& [di, dj] : {std::pair{-1, -1}, {-1, 1}, {1, -1}, {1, 1}})
        row[taps++] = motion[planes_.step(plane, di, dj)];
    if (stage == cross)
      for (const auto& [di, dj] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        row[taps++] = motion[planes_.step(plane, di, dj)];
    put_past(plane, cell, c, &row[taps]);
    row[taps + past_taps_of(prediction_)] = *motion;
    return row;
  }

  void put_past(int plane, std::size_t cell, std::size_t c, double* taps) const {
    const PastFields& past = past_.fields(c);
    const float* v = past.motion.data() + cell;
    const float* p = past_.first().values[c].data() + cell;
    const auto at = [&](const float* field, int di, int dj) {
      return static_cast<double>(field[planes_.step(plane, di, dj)]);
    };
    const double twice = 2 * static_cast<double>(*p);
    *taps++ = *v;
    *taps++ = at(v, -1, 0);
    *taps++ = at(v, 1, 0);
    *taps++ = at(v, 0, -1);
    *taps++ = at(v, 0, 1);
    *taps++ = at(v, -1, -1) + at(v, -1, 1) + at(v, 1, -1) + at(v, 1, 1);
    *taps++ = past.second_motion[cell];
    *taps++ = at(p, -1, 0) + at(p, 1, 0) - twice;
    *taps++ = at(p, 0, -1) + at(p, 0, 1) - twice;
    *taps++ = at(p, -1, -1) + at(p, -1, 1) + at(p, 1, -1) + at(p, 1, 1) - 2 * twice;
    *taps++ = past.along_pull[cell];
    *taps++ = past.across_pull[cell];
    if (prediction_ != Prediction::between) return;
    *taps++ = past.third_motion[cell];
    *taps++ = past.second_along_pull[cell];
    *taps++ = past.second_across_pull[cell];
  }

  // How far the past alone is off in plane 0; nothing outside of it.
  [[nodiscard]] double missed(std::size_t cell, std::size_t c) const {
    const std::size_t within = cell - planes_.cell(0, 0, 0);
    const auto stride = static_cast<std::size_t>(planes_.stride());
    if (cell < planes_.cell(0, 0, 0) ||
        within % stride >= static_cast<std::size_t>(planes_.columns(0)) ||
        within / stride >= static_cast<std::size_t>(planes_.rows(0)))
      return 0;
    std::array<double, past_taps> taps{};
    put_past(0, cell, c, taps.data());
    double left = motion_[c][cell];
    for (std::size_t tap = 0; tap < past_taps_of(prediction_); ++tap)
      left -= static_cast<double>(weights_[coarse_past][near_taps + tap]) * taps[tap];
    return left;
  }

  const ParityPlanes& planes_;
  const Past& past_;
  Prediction prediction_;
  const PlaneFields<float>& motion_;
  std::size_t samples_per_stage_;
  double unit_ = 1;
  RecordedWeights fitted_;
  Weights weights_{};
};

}  // namespace

namespace {

float rounded_middle_weight(double weight) {
  return static_cast<float>(std::clamp(std::floor(64 * weight + 0.5), -127.0, 127.0) / 64);
}

}  // namespace

WithinWeights fit_within_weights(const ParityPlanes& planes, const PlaneFields<float>& values) {
  WithinWeights weights;
  for (const std::size_t stage : {std::size_t{0}, std::size_t{1}}) {
    NormalEquations equations(2);
    const int plane = stage == 0 ? 3 : 1;
    const int reach = stage == 0 ? 3 : 2;
    for (int a = 0; a < planes.rows(plane); a += 2)
      for (int b = 0; b < planes.columns(plane); ++b)
        for (std::size_t c = 0; c < 3; ++c) {
          const float* x = values[c].data() + planes.cell(plane, a, b);
          const auto mean_of = [&](std::initializer_list<std::pair<int, int>> places) {
            double sum = 0;
            for (const auto& [di, dj] : places)
              sum += static_cast<double>(x[planes.step(plane, di, dj)]);
            return sum / static_cast<double>(places.size());
          };
          const double along = stage == 0 ? 0 : mean_of({{-1, 0}, {1, 0}});
          const double across = stage == 0 ? 0 : mean_of({{0, -1}, {0, 1}});
          const double middle =
              stage == 0 ? mean_of({{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}) : (along + across) / 2;
          const double outer = mean_of({{-reach, -1}, {-reach, 1}, {reach, -1}, {reach, 1}});
          Row row{};
          row[0] = along - across;
          row[1] = outer - middle;
          row[2] = static_cast<double>(*x) - middle;
          equations.add(row, 1);
        }
    const auto solved = equations.solution();
    weights[stage] = {stage == 0 ? 0.0F : rounded_middle_weight(solved[0]),
                      rounded_middle_weight(solved[1])};
  }
  return weights;
}

RecordedWeights fit_weights(const ParityPlanes& planes, const Past& past, Prediction prediction,
                            const PlaneFields<float>& motion, Fit fit) {
  return WeightFit(planes, past, prediction, motion, fit).run();
}

}  // namespace ribbon

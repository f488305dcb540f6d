#include "recording/codec/fit_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <utility>
#include <vector>

namespace ribbon {

namespace {

constexpr std::size_t quick_groups_per_stage = 40;

// Sums of products of taps, and of taps with the wanted value, which comes last.
class NormalEquations {
 public:
  using Row = std::array<double, most_taps + 1>;

  explicit NormalEquations(std::size_t taps) : taps_(taps) {}
  NormalEquations(std::size_t taps, const NormalSums& sums) : taps_(taps), weight_(sums.weight) {
    for (std::size_t a = 0; a <= taps; ++a)
      for (std::size_t b = a; b <= taps; ++b)
        sums_[a][b] = std::accumulate(sums.products[a][b].begin(), sums.products[a][b].end(), 0.0);
  }

  // row: the taps, then the wanted value.
  void add(const Row& row) {
    for (std::size_t a = 0; a <= taps_; ++a)
      for (std::size_t b = a; b <= taps_; ++b) sums_[a][b] += row[a] * row[b];
    ++weight_;
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
    const auto is_finite = [](double weight) { return std::isfinite(weight); };
    if (!std::all_of(solved.begin(), solved.end(), is_finite)) solved.fill(0);
    return solved;
  }

  // What is left of the wanted values' squares, per weight; after solution().
  [[nodiscard]] double mean_square_left() const {
    double left = sums_[taps_][taps_];
    for (std::size_t a = 0; a < taps_; ++a) left -= sums_[a][taps_] * sums_[a][taps_];
    return std::max(left, 0.0) / std::max(weight_, 1e-300);
  }
  [[nodiscard]] double mean_square_wanted() const {
    return sums_[taps_][taps_] / std::max(weight_, 1e-300);
  }

 private:
  [[nodiscard]] double noise() const { return 1e-9 * sums_[taps_][taps_] + 1e-30; }

  std::size_t taps_;
  double weight_ = 0;
  std::array<Row, most_taps + 1> sums_{};
};

// Fine enough that rounded weights add a tenth to what the prediction misses.
int shift_for(const NormalEquations& solved) {
  const double ratio =
      std::sqrt(solved.mean_square_wanted() / std::max(solved.mean_square_left(), 1e-30));
  return std::clamp(static_cast<int>(std::ilogb(ratio > 1 ? std::min(ratio, 1e9) : 1.0)) + 6, 6,
                    20);
}

std::vector<CellGroup> groups_of(const PolyphasePlanes& planes, int plane, int begin, int end) {
  std::vector<CellGroup> groups;
  for (int b = begin; b < end; ++b)
    for (int a = 0; a < planes.rows(plane); a += PolyphasePlanes::lane_quantum)
      groups.push_back({plane, planes.cell(plane, a, b),
                        std::min(PolyphasePlanes::lane_quantum, planes.rows(plane) - a)});
  return groups;
}

std::vector<CellGroup> groups_of(const PolyphasePlanes& planes, std::size_t stage) {
  if (stage == first_column) return groups_of(planes, 0, 0, 1);
  if (stage == coarse) return groups_of(planes, 0, 1, planes.columns(0));
  if (stage == diagonal) return groups_of(planes, 3, 0, planes.columns(3));
  auto groups = groups_of(planes, 1, 0, planes.columns(1));
  const auto others = groups_of(planes, 2, 0, planes.columns(2));
  groups.insert(groups.end(), others.begin(), others.end());
  return groups;
}

// Evenly spread.
void thin_out(std::vector<CellGroup>& groups, std::size_t wanted) {
  if (groups.size() <= wanted) return;
  for (std::size_t k = 0; k < wanted; ++k) groups[k] = groups[k * groups.size() / wanted];
  groups.resize(wanted);
}

class WeightFit {
 public:
  WeightFit(const PredictedFrame& frame, Fit fit) : frame_(frame), fit_(fit) {
    if (!frame.uniform) unit_ = mean_change();
  }

  [[nodiscard]] RecordedWeights run() const {
    std::array<std::array<double, most_taps>, prediction_stage_count> solved{};
    RecordedWeights fitted;
    for (std::size_t stage = 0; stage < prediction_stage_count; ++stage) {
      NormalEquations equations = equations_of(stage);
      solved[stage] = equations.solution();
      if (stage == cross) fitted.shift = shift_for(equations);
    }
    for (std::size_t stage = 0; stage < prediction_stage_count; ++stage)
      round(stage, solved[stage], fitted);
    return fitted;
  }

 private:
  [[nodiscard]] NormalEquations equations_of(std::size_t stage) const {
    auto groups = groups_of(*frame_.planes, stage);
    if (fit_ == Fit::quick) thin_out(groups, quick_groups_per_stage);
    NormalSums sums;
    loops().fit(frame_, stage, groups, unit_, sums);
    return {near_taps_of(stage) + past_taps_of(frame_.prediction), sums};
  }

  void round(std::size_t stage, const std::array<double, most_taps>& solved,
             RecordedWeights& fitted) const {
    const auto rounded = [&](double weight) {
      constexpr double limit = 1 << 24;
      return static_cast<std::int32_t>(
          std::clamp(std::floor(std::ldexp(weight, fitted.shift) + 0.5), -limit, limit));
    };
    const auto* past = solved.begin() + near_taps_of(stage);
    std::transform(solved.begin(), past, fitted.stages[stage].near.begin(), rounded);
    std::transform(past, past + past_taps_of(frame_.prediction), fitted.stages[stage].past.begin(),
                   rounded);
  }

  // Without a quantisation step nothing else tells what restless is.
  [[nodiscard]] float mean_change() const {
    double sum = 0;
    double count = 0;
    for (const CellGroup& group : groups_of(*frame_.planes, diagonal))
      for (std::size_t cell = group.cell; cell < group.cell + group.count; ++cell, ++count)
        sum += change_at(cell);
    return static_cast<float>(sum / count + 1e-30);
  }

  [[nodiscard]] double change_at(std::size_t cell) const {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto value = [&](std::size_t k) {
        return static_cast<double>(frame_.reference_values[k][c][cell]);
      };
      const bool is_b = frame_.prediction == Prediction::b;
      sum += is_b ? std::abs((value(3) - value(1)) - (value(0) - value(2)))
                  : std::abs((value(0) - value(1)) - (value(1) - value(2)));
    }
    return sum / 3;
  }

  const PredictedFrame& frame_;
  Fit fit_;
  float unit_ = 1;
};

float rounded_middle_weight(double weight) {
  return static_cast<float>(std::clamp(std::floor(64 * weight + 0.5), -127.0, 127.0) / 64);
}

}  // namespace

RecordedWeights fit_weights(const PredictedFrame& frame, Fit fit) {
  return WeightFit(frame, fit).run();
}

IntraWeights fit_intra_weights(const PolyphasePlanes& planes, const PlaneFields<float>& values) {
  IntraWeights weights;
  for (const std::size_t stage : {std::size_t{0}, std::size_t{1}}) {
    NormalEquations equations(2);
    const int plane = stage == 0 ? 3 : 1;
    const int reach = stage == 0 ? 3 : 2;
    for (int a = 0; a < planes.rows(plane); a += 2)
      for (int b = 0; b < planes.columns(plane); ++b)
        for (std::size_t c = 0; c < 3; ++c) {
          const float* x = values[c].data() + planes.cell(plane, a, b);
          const auto mean_of = [&](std::initializer_list<std::pair<int, int>> steps) {
            double sum = 0;
            for (const auto& [di, dj] : steps)
              sum += static_cast<double>(x[planes.step(plane, di, dj)]);
            return sum / static_cast<double>(steps.size());
          };
          const double along = stage == 0 ? 0 : mean_of({{-1, 0}, {1, 0}});
          const double across = stage == 0 ? 0 : mean_of({{0, -1}, {0, 1}});
          const double middle =
              stage == 0 ? mean_of({{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}) : (along + across) / 2;
          const double outer = mean_of({{-reach, -1}, {-reach, 1}, {reach, -1}, {reach, 1}});
          equations.add({along - across, outer - middle, static_cast<double>(*x) - middle});
        }
    const auto solved = equations.solution();
    weights[stage] = {stage == 0 ? 0.0F : rounded_middle_weight(solved[0]),
                      rounded_middle_weight(solved[1])};
  }
  return weights;
}

}  // namespace ribbon

#include "simulation/truncation/chain_tensions.h"

#include <cstddef>
#include <utility>

namespace ribbon {

namespace {

constexpr int most_solutions = 30;

}  // namespace

ChainTensions::ChainTensions(std::vector<double> weights)
    : weights_(std::move(weights)),
      tensions_(weights_.size() - 1),
      eliminated_(tensions_.size()),
      is_tense_(tensions_.size()),
      was_tense_(tensions_.size()) {}

std::span<const double> ChainTensions::find(std::span<const double> slack,
                                            std::span<const double> cosines, double tight) {
  for (std::size_t i = 0; i < tensions_.size(); ++i) is_tense_[i] = slack[i] < tight ? 1 : 0;
  solve(slack, cosines);
  for (int solutions = 1; solutions < most_solutions && revise(slack, cosines); ++solutions)
    solve(slack, cosines);
  return tensions_;
}

// The links under tension become just as long as they may: Gaussian elimination, run by run.
void ChainTensions::solve(std::span<const double> slack, std::span<const double> cosines) {
  const std::size_t links = tensions_.size();
  for (std::size_t i = 0; i < links; ++i) {
    tensions_[i] = 0;
    if (is_tense_[i] == 0) continue;
    double pivot = weights_[i] + weights_[i + 1];
    double wanted = -slack[i];
    if (i > 0 && is_tense_[i - 1] != 0) {
      const double beside = weights_[i] * cosines[i - 1];
      pivot -= beside * eliminated_[i - 1];
      wanted += beside * tensions_[i - 1];
    }
    const bool has_next = i + 1 < links && is_tense_[i + 1] != 0;
    eliminated_[i] = has_next ? weights_[i + 1] * cosines[i] / pivot : 0;
    tensions_[i] = wanted / pivot;
  }
  for (std::size_t i = links - 1; i-- > 0;)
    if (is_tense_[i] != 0 && is_tense_[i + 1] != 0)
      tensions_[i] += eliminated_[i] * tensions_[i + 1];
}

// Links that push are not under tension, and those are that their neighbours make too long. Is
// anything else than it was?
bool ChainTensions::revise(std::span<const double> slack, std::span<const double> cosines) {
  const std::size_t links = tensions_.size();
  was_tense_ = is_tense_;
  for (std::size_t i = 0; i < links; ++i) {
    if (was_tense_[i] != 0) {
      is_tense_[i] = tensions_[i] > 0 ? 1 : 0;
      continue;
    }
    double left = slack[i];
    if (i > 0 && was_tense_[i - 1] != 0) left -= weights_[i] * cosines[i - 1] * tensions_[i - 1];
    if (i + 1 < links && was_tense_[i + 1] != 0)
      left -= weights_[i + 1] * cosines[i] * tensions_[i + 1];
    is_tense_[i] = left < 0 ? 1 : 0;
  }
  return is_tense_ != was_tense_;
}

}  // namespace ribbon

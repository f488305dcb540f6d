#include "simulation/fastening/slip_guard.h"

#include <cstddef>

namespace ribbon {

namespace {

constexpr double too_short = 1.5;    // widths
constexpr double moment_before = 2;  // widths more, at most

}  // namespace

void SlipGuard::look(const LooseEnds& ends) {
  for (std::size_t end = 0; end < ends.size(); ++end) {
    const double before_m = loose_m_[end];
    loose_m_[end] = ends[end].value_or(0);
    const bool was_long =
        before_m >= too_short * width_m_ && before_m < (too_short + moment_before) * width_m_;
    if (was_long && ends[end] && *ends[end] < too_short * width_m_ && slipping_ < 0)
      slipping_ = static_cast<int>(end);
  }
}

std::optional<int> SlipGuard::slipping_end() const {
  return slipping_ < 0 ? std::nullopt : std::optional(slipping_);
}

void SlipGuard::visit_memory(StateArchive& archive) {
  auto& [width, loose, slipping] = *this;
  for (double& length_m : loose) archive.visit(length_m);
  archive.visit(slipping, -1, 1);
}

}  // namespace ribbon

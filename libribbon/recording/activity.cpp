#include "recording/activity.h"

#include <algorithm>
#include <bit>

#include "recording/varint.h"

namespace ribbon {

Activity::Activity(const PaddedGrid& grid) : grid_(grid) {
  forget();
}

void Activity::forget() {
  for (auto& plane : recent_) plane.assign(grid_.size(), 0);
  for (auto& plane : class_) plane.assign(grid_.size(), 0);
}

void Activity::remember(const Residuals& residuals) {
  constexpr std::uint32_t largest = 2047;
  const auto stride = static_cast<std::size_t>(grid_.stride);
  for (std::size_t component = 0; component < 3; ++component) {
    auto& recent = recent_[component];
    for_each_particle(grid_, [&](std::size_t at) {
      // Half of a zigzag number, rounded up, is its absolute value.
      const std::uint32_t number = zigzag(residuals[component][at]);
      const std::uint32_t size = std::min(number / 2 + number % 2, largest);
      recent[at] = static_cast<std::uint16_t>((recent[at] + 16 * size + 1) / 2);
    });
    for_each_particle(grid_, [&](std::size_t at) {
      const auto around =
          static_cast<std::uint32_t>(2 * recent[at] + recent[at - stride] + recent[at + stride] +
                                     recent[at - 1] + recent[at + 1]);
      class_[component][at] = static_cast<std::uint8_t>(
          std::clamp(static_cast<int>(std::bit_width(around)) - 5, 0, classes - 1));
    });
  }
}

}  // namespace ribbon

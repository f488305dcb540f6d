// Which frames another one is predicted from.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "recording/codec/quantised_frame.h"

namespace ribbon {

inline constexpr std::size_t most_references = 2;

// Frame numbers, from 0, in the order in which the codec gets them. Holds at most two, in itself:
// a long recording has one for each frame.
class ReferenceList {
 public:
  void push_back(std::uint32_t frame) {
    assert(count_ < most_references);
    frames_[count_++] = frame;
  }

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] const std::uint32_t* begin() const { return frames_.data(); }
  [[nodiscard]] const std::uint32_t* end() const { return frames_.data() + count_; }
  [[nodiscard]] std::uint32_t operator[](std::size_t i) const { return frames_[i]; }

  bool operator==(const ReferenceList&) const = default;

 private:
  std::array<std::uint32_t, most_references> frames_{};  // 0 behind the last
  std::uint8_t count_ = 0;
};

// The frames of some numbers, as the codec wants them: frame_of(number) points to each.
template <class Numbers, class FrameOf>
std::vector<const QuantisedFrame*> frames_of(const Numbers& references, const FrameOf& frame_of) {
  std::vector<const QuantisedFrame*> frames;
  frames.reserve(references.size());
  for (const auto reference : references) frames.push_back(frame_of(reference));
  return frames;
}

}  // namespace ribbon

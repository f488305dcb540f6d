// The payload of a frame record (FORMAT.md, section 5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "recording/recording.h"

namespace ribbon {

// Before the geometry.
inline constexpr std::size_t frame_fields_bytes = 40;

enum class FrameEncoding : std::uint32_t { plain = 0, lattice = 1 };

struct FrameRecord {
  std::uint32_t recording_id = 0;
  std::uint32_t frame = 0;             // from 0
  std::uint32_t frames_since_key = 0;  // how many frames before it are needed
  FrameEncoding encoding{};
  FrameNumbers numbers;
  std::string_view geometry;  // borrowed
};

std::string frame_payload(const FrameRecord& record);

// Borrows the geometry from `payload`. Nothing where the payload is too short or the encoding is
// unknown.
std::optional<FrameRecord> parse_frame_payload(std::string_view payload);

}  // namespace ribbon

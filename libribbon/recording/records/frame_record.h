// The payload of a frame record (FORMAT.md, section 5.1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "recording/codec/quantised_frame.h"
#include "recording/records/recording.h"

namespace ribbon {

// Before reference and tightness.
inline constexpr std::size_t frame_fields_bytes = 40;

struct FrameRecord {
  std::uint32_t recording_id = 0;
  std::uint32_t frame = 0;  // from 0
  FrameEncoding encoding{};
  std::optional<std::uint32_t> reference = std::nullopt;  // number of a frame
  FrameNumbers numbers = {};
  std::string_view geometry = {};  // borrowed

  bool operator==(const FrameRecord&) const = default;
};

std::string frame_payload(const FrameRecord& record);

// Borrows the geometry from `payload`. Nothing where the payload is too short or the encoding
// is unknown.
std::optional<FrameRecord> parse_frame_payload(std::string_view payload);

}  // namespace ribbon

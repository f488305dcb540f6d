// The payload of a frame record (FORMAT.md, section 5.1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "recording/codec/quantised_frame.h"
#include "recording/records/recording.h"
#include "recording/records/reference_list.h"

namespace ribbon {

// Before references and tightness.
inline constexpr std::size_t frame_fields_bytes = 40;

struct FrameRecord {
  std::uint32_t recording_id = 0;
  std::uint32_t frame = 0;  // from 0
  FrameEncoding encoding{};
  ReferenceList references = {};
  FrameNumbers numbers = {};
  std::string_view geometry = {};  // borrowed

  bool operator==(const FrameRecord&) const = default;
};

std::string frame_payload(const FrameRecord& record);

// Borrows the geometry from `payload`. Nothing where the payload is too short, the encoding is
// unknown or the references are too many.
std::optional<FrameRecord> parse_frame_payload(std::string_view payload);

}  // namespace ribbon

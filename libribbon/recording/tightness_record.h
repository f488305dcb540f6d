// The payload of a tightness record (FORMAT.md, section 5.1).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "recording/recording.h"

namespace ribbon {

struct TightnessRecord {
  std::uint32_t recording_id = 0;
  std::uint32_t frame = 0;  // from 0
  TightnessNumbers numbers;
};

std::string tightness_payload(const TightnessRecord& record);

// Nothing where the payload is too short.
std::optional<TightnessRecord> parse_tightness_payload(std::string_view payload);

}  // namespace ribbon

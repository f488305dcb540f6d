// The payload of a session record (FORMAT.md, section 5.3).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "recording/records/recording.h"

namespace ribbon {

std::string session_payload(std::uint32_t recording_id, const Session& session);

// Nothing where the payload is too short or of another recording.
std::optional<Session> parse_session_payload(std::string_view payload, std::uint32_t recording_id);

}  // namespace ribbon

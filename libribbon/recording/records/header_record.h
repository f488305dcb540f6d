// The payload of the header record (FORMAT.md, section 4).
#pragma once

#include <string>
#include <string_view>

#include "recording/records/recording.h"
#include "result/result.h"

namespace ribbon {

// May a recording have this grid?
bool is_recordable(const RibbonGrid& grid);

std::string header_payload(const RecordingHeader& header);

// Fails, with the error's place still to be filled in, when the payload is of another major version
// or not valid in itself.
Result<RecordingHeader> parse_header_payload(std::string_view payload);

}  // namespace ribbon

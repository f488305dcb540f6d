// The payload of the header record (FORMAT.md, section 4).
#pragma once

#include <string>
#include <string_view>

#include "recording/records/recording.h"
#include "result/result.h"

namespace ribbon {

// Finite, and above 0 or at least 0: what a header's lengths, rates and bounds have to be.
bool is_positive(double number);
bool is_positive_or_zero(double number);

// May a recording have this grid?
bool is_recordable(const RibbonGrid& grid);

// Fails, with the error's place still to be filled in, where the ribbon has more particles, or the
// obstacle more vertices or triangles, than a recording holds, and where no reader would accept it.
Result<void> check_recordable(const RecordingHeader& header);

// Of a header that is recordable.
std::string header_payload(const RecordingHeader& header);

// Fails, with the error's place still to be filled in, when the payload is of another major version
// or not valid in itself.
Result<RecordingHeader> parse_header_payload(std::string_view payload);

}  // namespace ribbon

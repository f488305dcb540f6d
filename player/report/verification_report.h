// What verifying a recording has found, for people and for programs.
#pragma once

#include <string>

#include "inspection/verify_recording.h"

namespace ribbon {

// Several lines to read.
std::string verification_text(const std::string& file, const Verification& verification);

// One JSON object; what is not known is null.
std::string verification_json(const std::string& file, const Verification& verification);

}  // namespace ribbon

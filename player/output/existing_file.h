// Nothing that is there is replaced unless the user says so.
#pragma once

#include <filesystem>

#include "result/result.h"

namespace ribbon {

// Fails where a file of this name is there and is not to be replaced.
Result<void> check_place(const std::filesystem::path& file, bool replaces);

}  // namespace ribbon

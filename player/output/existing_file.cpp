#include "player/output/existing_file.h"

#include <system_error>

namespace ribbon {

Result<void> check_place(const std::filesystem::path& file, bool replaces) {
  std::error_code code;
  if (replaces || !std::filesystem::is_regular_file(file, code)) return {};
  return failure(
      file.string(), "exists already",
      "choose another name, replace it by --force, or go on with a sequence by --resume");
}

}  // namespace ribbon

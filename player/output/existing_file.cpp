#include "player/output/existing_file.h"

#include "files/files.h"

namespace ribbon {

Result<void> check_place(const std::filesystem::path& file, bool replaces) {
  if (replaces || !is_taken(file)) return {};
  return failure(
      file.string(), "exists already",
      "choose another name, replace it by --force, or go on with a sequence by --resume");
}

}  // namespace ribbon

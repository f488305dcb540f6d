#include "player/output/existing_file.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "files/files.h"

namespace ribbon {

Result<void> check_place(const std::filesystem::path& file, const Replaceable& replaceable,
                         std::string_view other_way) {
  if (!is_taken(file)) return {};
  std::error_code code;
  if (std::filesystem::is_directory(file, code))
    return failure(file.string(), "is a folder", "choose another name");
  const auto is_it = [&](const std::filesystem::path& read) { return is_same_file(file, read); };
  if (std::ranges::any_of(replaceable.never, is_it))
    return failure(file.string(), "is read for what would be written there", "choose another name");
  if (replaceable.all) return {};
  return failure(file.string(), "exists already",
                 "choose another name, or replace it by --force" + std::string(other_way));
}

}  // namespace ribbon

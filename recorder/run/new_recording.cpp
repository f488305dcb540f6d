#include "recorder/run/new_recording.h"

#include <system_error>

namespace ribbon {

Result<void> NewRecording::check_place() const {
  std::error_code code;
  const bool is_there = std::filesystem::exists(std::filesystem::symlink_status(file, code));
  if (!is_there || overwrite == Overwrite::yes || std::filesystem::is_other(file, code)) return {};
  return failure(file.string(), "exists already",
                 "go on with that recording by --resume, replace it by --force, or name another "
                 "file after -o");
}

std::string NewRecording::settings_text() const {
  std::string text;
  for (const std::string& setting : settings) text += setting + "\n";
  return text;
}

}  // namespace ribbon

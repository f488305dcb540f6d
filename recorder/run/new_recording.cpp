#include "recorder/run/new_recording.h"

#include <system_error>

#include "files/files.h"

namespace ribbon {

Result<void> NewRecording::check_place() const {
  std::error_code code;
  if (std::filesystem::is_directory(file, code))
    return failure(file.string(), "is a folder", "name a file after -o");
  if (overwrite == Overwrite::yes || !is_taken(file)) return {};
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

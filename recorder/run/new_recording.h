// A recording to begin.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recording/writer/recording_writer.h"
#include "result/result.h"

namespace ribbon {

struct NewRecording {
  std::filesystem::path file;
  std::string program;                     // that writes it, and version
  std::vector<std::string> settings = {};  // of the scene that were changed: "fastening.speed=0.3"
  Overwrite overwrite = Overwrite::no;     // of an older file

  // Fails where it would take the place of an older file and may not, or of a folder. To be asked
  // before the long work that comes first; the writer asks again.
  [[nodiscard]] Result<void> check_place() const;

  // One a line, as recordings hold them.
  [[nodiscard]] std::string settings_text() const;
};

}  // namespace ribbon

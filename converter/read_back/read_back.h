// Opening what a conversion has written.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "converter/read_back/written_motion.h"

namespace ribbon {

struct FileReader {
  std::string_view extension;
  std::unique_ptr<WrittenMotion> (*read)(const std::filesystem::path& path);  // throws Spoiled
  const char* name;  // who reads it, for people
};

// The one of an extension as ".abc"; null: there is none.
const FileReader* file_reader(std::string_view extension);

}  // namespace ribbon

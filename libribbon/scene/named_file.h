// A file that a scene names.
#pragma once

#include <filesystem>
#include <string>

#include "result/result.h"

namespace ribbon {

struct NamedFile {
  std::filesystem::path path;  // absolute, or relative to the working directory
  std::string place = {};      // where the scene names it: "knot.toml:12:8"; empty: nowhere

  // Wherever it is named.
  bool operator==(const NamedFile& other) const { return path == other.path; }
};

// Fails, with the place in the scene, where there is no such file, it is a folder, a device or a
// pipe, or cannot be opened.
Result<void> check_readable(const NamedFile& file);

// A failure with the place in the scene and the file's name in quotes before what is wrong.
tl::unexpected<Error> failure(const NamedFile& file, const std::string& problem,
                              const std::string& remedy);

}  // namespace ribbon

// What the user asks ribbon-record for.
#pragma once

#include <filesystem>
#include <optional>

#include "result/result.h"

namespace ribbon {

struct RecorderOptions {
  std::filesystem::path scene;
  std::filesystem::path recording;
  std::filesystem::path statistics;  // JSON file to write at the end; empty: none
  int threads = 0;                   // 0: all cores
  bool profile = false;
  bool quiet = false;
};

// Nothing when --help or --version was asked for: that has been printed to standard output. Fails
// when the command line cannot be understood.
Result<std::optional<RecorderOptions>> parse_options(int argc, const char* const* argv);

}  // namespace ribbon

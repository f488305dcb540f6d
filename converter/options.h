// What the user typed.
#pragma once

#include <optional>

#include "converter/conversion.h"
#include "result/result.h"

namespace ribbon {

struct CommandLine {
  ConversionRequest request;
  int threads = 0;  // 0: all cores
  bool dry_run = false;
  bool verify = false;                // reads back what was written, or is there already
  bool verify_only = false;           // writes nothing
  std::optional<double> tolerance_m;  // of that
  bool quiet = false;                 // no progress and no summary
};

// Nothing when help or the version was asked for, which this prints. Fails when it makes no sense.
Result<std::optional<CommandLine>> parse_command_line(int argc, const char* const* argv);

}  // namespace ribbon

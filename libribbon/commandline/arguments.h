// Reading a tool's command line.
#pragma once

#include "result/result.h"

namespace CLI {
class App;
}

namespace ribbon {

// Reads the arguments into what `app` was told to set. False when --help or --version was asked
// for: that has been printed to standard output. Fails when the command line cannot be understood.
Result<bool> parse_arguments(CLI::App& app, int argc, const char* const* argv);

}  // namespace ribbon

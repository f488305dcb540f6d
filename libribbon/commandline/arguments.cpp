#include "commandline/arguments.h"

#include <CLI/CLI.hpp>

namespace ribbon {

Result<bool> parse_arguments(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {
    app.exit(wish);  // prints the help or the version
    return false;
  } catch (const CLI::ParseError& problem) {
    return failure("", problem.what(), "see " + app.get_name() + " --help");
  }
  return true;
}

}  // namespace ribbon

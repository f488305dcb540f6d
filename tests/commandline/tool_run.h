// Runs a built tool as a user's shell would.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "files/files.h"

namespace ribbon {

struct ToolRun {
  int exit_code = -1;  // -1: ended by a signal
  std::string output;  // standard output
  std::string errors;  // standard error
};

// Runs `program` with `arguments` (as in a shell) in `folder`; `before` is shell code that comes
// first, for limits and such.
inline ToolRun run_in(const std::filesystem::path& folder, const std::string& program,
                      const std::string& arguments, const std::string& before = "") {
  const std::filesystem::path output = folder / "standard-output.txt";
  const std::filesystem::path errors = folder / "standard-error.txt";
  const std::string command = "cd '" + folder.string() + "' && " + before + " '" + program + "' " +
                              arguments + " > '" + output.string() + "' 2> '" + errors.string() +
                              "'";
  // NOLINTNEXTLINE(concurrency-mt-unsafe, cert-env33-c)
  const int status = std::system(command.c_str());
  ToolRun run{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(output).value_or(""),
              read_file(errors).value_or("")};
  std::filesystem::remove(output);
  std::filesystem::remove(errors);
  return run;
}

}  // namespace ribbon

// Runs a built tool as a user's shell would.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "result/refusal.h"

namespace ribbon {

using testing::ElementsAre;

struct ToolRun {
  std::string tool;    // its name
  int exit_code = -1;  // -1: ended by a signal
  std::string output;  // standard output
  std::string errors;  // standard error
};

// What it says where it could.
inline std::string output_of(const ToolRun& run) {
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.errors, "");
  return run.output;
}

// It says in one sentence, after its name, why it could not.
inline void expect_refusal(const ToolRun& run, const std::string& part) {
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, StartsWith(run.tool + ": "));
  EXPECT_THAT(run.errors, HasSubstr(part));
  EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
  EXPECT_EQ(run.output, "");
}

// A tool, and a folder in which it is run.
class ToolTest : public TestInFolder {
 protected:
  explicit ToolTest(std::string program) : program_(std::move(program)) {}

  // With arguments as in a shell; `before` is shell code that comes first, for limits and such.
  [[nodiscard]] ToolRun run(const std::string& arguments, const std::string& before = "") const {
    const std::string command = "cd '" + folder_.string() + "' && " + before + " '" + program_ +
                                "' " + arguments + " > '" + outputs_.string() + "/output' 2> '" +
                                outputs_.string() + "/errors'";
    // NOLINTNEXTLINE(concurrency-mt-unsafe, cert-env33-c)
    const int status = std::system(command.c_str());
    return {
        std::filesystem::path(program_).filename(), WIFEXITED(status) ? WEXITSTATUS(status) : -1,
        read_file(outputs_ / "output").value_or(""), read_file(outputs_ / "errors").value_or("")};
  }

  // A file's bytes; none where it is not there.
  [[nodiscard]] std::string bytes(const std::string& file) const {
    return read_file(folder_ / file).value_or("");
  }

  // What lies in a folder below.
  [[nodiscard]] std::set<std::string> names(const std::string& below) const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / below))
      names.insert(entry.path().filename());
    return names;
  }

 private:
  std::string program_;
  TemporaryFolder own_outputs_;
  const std::filesystem::path& outputs_ = own_outputs_.path();
};

}  // namespace ribbon

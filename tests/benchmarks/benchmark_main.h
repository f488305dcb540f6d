// A benchmark as a program, with options as the tools have them.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "commandline/tool.h"
#include "files/files.h"

namespace ribbon {

// describe(app, options) adds the options to the command line; run(options) does the rest.
template <class Options, class Describe, class Run>
int benchmark_main(const char* name, int argc, char** argv, const Describe& describe,
                   const Run& run) {
  return run_tool(name, [&]() -> Result<ExitCode> {
    CLI::App app("", name);
    Options options;
    describe(app, options);
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& wish) {
      return app.exit(wish) == 0 ? ExitCode::done : ExitCode::could_not;
    } catch (const CLI::ParseError& problem) {
      return failure("", problem.what(), std::string("see ") + name + " --help");
    }
    return run(options);
  });
}

inline void add_report_option(CLI::App& app, std::string& file) {
  app.add_option("--json", file, "write the figures there")->type_name("FILE");
}

// The end of a run: writes the report where a file was named, and answers `code`.
inline Result<ExitCode> write_report(const nlohmann::ordered_json& report, const std::string& file,
                                     ExitCode code) {
  if (!file.empty())
    if (auto written = write_file(file, report.dump(2) + "\n"); !written)
      return tl::unexpected(written.error());
  return code;
}

}  // namespace ribbon

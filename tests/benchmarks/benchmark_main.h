// A benchmark as a program, with options as the tools have them.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "commandline/tool.h"
#include "files/files.h"

namespace ribbon {

// What a benchmark found out, and whether it is as it should be. JSON is moved without exceptions,
// but for its own assertions. NOLINTNEXTLINE(bugprone-exception-escape)
struct Findings {
  nlohmann::ordered_json report;
  ExitCode code = ExitCode::done;
};

// describe(app, options) adds the options to the command line, run(options) gives a
// Result<Findings>. All have --json FILE, where the report is written.
template <class Options, class Describe, class Run>
int benchmark_main(const char* name, int argc, char** argv, const Describe& describe,
                   const Run& run) {
  return run_tool(name, [&]() -> Result<ExitCode> {
    CLI::App app("", name);
    Options options;
    std::string file;
    app.add_option("--json", file, "write the figures there")->type_name("FILE");
    describe(app, options);
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& wish) {
      return app.exit(wish) == 0 ? ExitCode::done : ExitCode::could_not;
    } catch (const CLI::ParseError& problem) {
      return failure("", problem.what(), std::string("see ") + name + " --help");
    }
    const auto findings = run(options);
    if (!findings) return tl::unexpected(findings.error());
    if (!file.empty())
      if (auto written = write_file(file, findings->report.dump(2) + "\n"); !written)
        return tl::unexpected(written.error());
    return findings->code;
  });
}

}  // namespace ribbon

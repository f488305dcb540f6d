// A benchmark as a program, with options as the tools have them.
#pragma once

#include <CLI/CLI.hpp>

#include "commandline/arguments.h"
#include "commandline/tool.h"

namespace ribbon {

// describe(app, options) adds the options to the command line; run(options) does the rest.
template <class Options, class Describe, class Run>
int benchmark_main(const char* name, int argc, char** argv, const Describe& describe,
                   const Run& run) {
  return run_tool(name, [&]() -> Result<ExitCode> {
    CLI::App app("", name);
    Options options;
    describe(app, options);
    const auto read = parse_arguments(app, argc, argv);
    if (!read) return tl::unexpected(read.error());
    return *read ? run(options) : ExitCode::done;
  });
}

}  // namespace ribbon

#include "recorder/options.h"

#include <CLI/CLI.hpp>

#include "commandline/arguments.h"

namespace ribbon {

namespace {

constexpr const char* examples = R"(Examples:
  ribbon-record knot.toml -o knot.rbn
      fastens the ribbon of the scene and records it
  ribbon-record knot.toml -o knot.rbn --quiet --stats knot.json
      without progress and summary; figures of the run go to a file
Ctrl-C ends the run early and leaves a valid recording of what was done.

Exit codes: 0 done (also when ended by Ctrl-C), 2 could not.)";

}  // namespace

Result<std::optional<RecorderOptions>> parse_options(int argc, const char* const* argv) {
  RecorderOptions options;
  CLI::App app("Fastens the ribbon of a scene and records every frame.", "ribbon-record");
  app.set_version_flag("--version", "ribbon-record " RIBBON_VERSION);
  app.footer(examples);
  app.add_option("SCENE", options.scene, "the scene (.toml)")->required();
  app.add_option("-o,--output", options.recording, "the recording to write (.rbn)")
      ->required()
      ->type_name("FILE");
  app.add_option("--stats", options.statistics, "JSON file for the figures of the run")
      ->type_name("FILE");
  app.add_option("--threads", options.threads,
                 "use at most this many threads (default: all cores); the recording is the same")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_flag("--profile", options.profile, "print where the time of the run went");
  app.add_flag("--quiet", options.quiet, "no progress and no summary");
  const auto read = parse_arguments(app, argc, argv);
  if (!read) return tl::unexpected(read.error());
  if (!*read) return std::nullopt;
  return options;
}

}  // namespace ribbon

#include "converter/options.h"

#include <CLI/CLI.hpp>

#include "commandline/arguments.h"

namespace ribbon {

namespace {

constexpr const char* examples = R"(Examples:
  ribbon-convert knot.rbn -o 'out/knot.{frame:04}.obj'   one OBJ a frame, one material library
  ribbon-convert knot.rbn -o 'out/knot.{frame:04}.fbx'   one FBX a frame
  ribbon-convert knot.rbn -o out/knot.pc2                all frames in one point cache, and out/knot.obj
                                                         as the mesh that it deforms
  ribbon-convert knot.rbn -o last.obj --frames -1        the last frame alone
  ribbon-convert knot.rbn -o 'few.{frame}.fbx' --frames 1:-1:10

Metres, y up, vertices in the recorded order in every frame.
Exit code: 0 done; 1 the recording is damaged (what can be read is written, what is missing is listed);
2 could not.)";

void add_options(CLI::App& app, CommandLine& line, std::string& objects) {
  ConversionRequest& request = line.request;
  app.add_option("recording", request.recording, "The recording, as ribbon-record wrote it")
      ->required()
      ->type_name("KNOT.rbn");
  app.add_option("-o,--output", request.output,
                 "Where to: .obj or .fbx with {frame} or {frame:04} for the number, or .pc2")
      ->required()
      ->type_name("FILE");
  app.add_option("--frames", request.frames,
                 "Frames from 1, both ends included; -1 is the last (default: all)")
      ->type_name("A:B:STEP");
  app.add_option("--object", objects, "What to write: both or ribbon")
      ->check(CLI::IsMember({"both", "ribbon"}))
      ->capture_default_str()
      ->type_name("NAME");
  app.add_option("--threads", line.threads, "How many threads to use (default: all cores)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_flag("--quiet", request.quiet, "No progress and no summary");
  app.set_version_flag("--version", "ribbon-convert " RIBBON_VERSION);
}

}  // namespace

Result<std::optional<CommandLine>> parse_command_line(int argc, const char* const* argv) {
  CLI::App app("Writes a recording as files for modelling packages.", "ribbon-convert");
  app.footer(examples);
  CommandLine line;
  std::string objects = "both";
  add_options(app, line, objects);
  const auto read = parse_arguments(app, argc, argv);
  if (!read) return tl::unexpected(read.error());
  if (!*read) return std::nullopt;
  line.request.with_obstacle = objects == "both";
  return line;
}

}  // namespace ribbon

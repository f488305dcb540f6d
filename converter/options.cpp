#include "converter/options.h"

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

// What is chosen by words.
struct Words {
  std::string faces = "triangles";
  std::string objects = "both";
};

void add_options(Arguments& arguments, CommandLine& line, Words& words) {
  ConversionRequest& request = line.request;
  arguments
      .add("recording", request.recording, "KNOT.rbn", "The recording, as ribbon-record wrote it")
      .required();
  arguments
      .add("-o,--output", request.output, "FILE",
           "Where to: .obj or .fbx with {frame} or {frame:04} for the number, or .pc2")
      .required();
  arguments.add("--frames", request.frames, "A:B:STEP",
                "Frames from 1, both ends included; -1 is the last (default: all)");
  arguments
      .add("--faces", words.faces, "KIND",
           "Of the ribbon: triangles, which the recording certifies, or quads")
      .one_of({"triangles", "quads"})
      .with_default_shown();
  arguments.add("--object", words.objects, "NAME", "What to write: both or ribbon")
      .one_of({"both", "ribbon"})
      .with_default_shown();
  arguments.add("--threads", line.threads, {1, 1024}, "N",
                "How many threads to use (default: all cores)");
  arguments.flag("--quiet", request.quiet, "No progress and no summary");
}

}  // namespace

Result<std::optional<CommandLine>> parse_command_line(int argc, const char* const* argv) {
  Arguments arguments("ribbon-convert", "Writes a recording as files for modelling packages.",
                      RIBBON_VERSION, examples);
  CommandLine line;
  Words words;
  add_options(arguments, line, words);
  const auto read = arguments.parse(argc, argv);
  if (!read) return tl::unexpected(read.error());
  if (!*read) return std::nullopt;
  ModelSettings& model = line.request.model;
  model.faces = words.faces == "quads" ? RibbonFaces::quads : RibbonFaces::triangles;
  model.with_obstacle = words.objects == "both";
  return line;
}

}  // namespace ribbon

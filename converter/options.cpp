#include "converter/options.h"

#include "commandline/arguments.h"

namespace ribbon {

namespace {

constexpr const char* examples = R"(Examples:
  ribbon-convert knot.rbn -o 'out/knot.{frame:04}.obj'   one OBJ a frame, one material library
  ribbon-convert knot.rbn -o 'out/knot.{frame:04}.fbx'   one FBX a frame
  ribbon-convert knot.rbn -o out/knot.abc                all frames in one file: Alembic; or .fbx, .glb
                                                         (glTF), .usda (USD)
  ribbon-convert knot.rbn -o out/knot.mdd                all frames in one point cache (or .pc2), and
                                                         out/knot.obj as the mesh that it deforms
  ribbon-convert knot.rbn -o out/knot.npy                positions as an array for NumPy
  ribbon-convert knot.rbn -o out/knot.csv                the numbers of each frame as a table
  ribbon-convert knot.rbn -o last.obj --frames -1        the last frame alone
  ribbon-convert knot.rbn -o 'few.{frame}.fbx' --frames 1:-1:10
  ribbon-convert knot.rbn -o part.rbn --frames 100:200   a recording of these frames
  ribbon-convert knot.rbn -o out/knot.abc --verify       reads the file back and compares it
  ribbon-convert knot.rbn -o rock.obj --object obstacle  what does not move, once
  ribbon-convert knot.rbn -o 'max.{frame:04}.fbx' --up z --unit cm

Metres and y up unless told otherwise; vertices in the recorded order, and the triangles that the
recording certifies, in every frame.
Exit code: 0 done; 1 the recording is damaged, or cloth cannot be made a solid (all other frames are
written, what is missing is listed), or --verify has found that a file is not as recorded;
2 could not; 3 interrupted, or the disk was full: --resume goes on with files of single frames,
others begin again.)";

// What is chosen by words, and numbers that may be left out.
struct Words {
  std::string faces = "triangles";
  std::string objects = "both";
  std::string up = "y";
  std::string unit = "m";
  int start_frame = 0;
  std::string progress = "line";
  double tolerance_m = 0;
};

void add_what(Arguments& arguments, ConversionRequest& request, Words& words) {
  arguments.add("--frames", request.frames, "1,5,A:B:STEP",
                "Frames by number and from A to B, every STEP-th; -1 is the last (default: all)");
  arguments.add("--object", words.objects, "NAME", "What to write: ribbon, obstacle or both")
      .one_of({"both", "ribbon", "obstacle"})
      .with_default_shown();
  arguments
      .add("--faces", words.faces, "KIND",
           "Of the ribbon: triangles, which the recording certifies, or quads")
      .one_of({"triangles", "quads"})
      .with_default_shown();
  arguments.add("--thickness", request.model.thickness_m,
                {ConversionRequest::least_thickness_m, ConversionRequest::most_thickness_m}, "M",
                "Makes the ribbon a closed solid, so many recorded metres thick");
  const auto texture =
      arguments.add("--texture", request.texture, "FILE",
                    "PNG or JPEG on the ribbon: as high as that is wide, repeated along it");
  arguments
      .add("--texture-back", request.texture_back, "FILE",
           "PNG or JPEG on the back of a ribbon with --thickness (default: the same)")
      .needs(texture);
  arguments.flag("--normals", request.model.with_normals,
                 "Smooth normals at the vertices; without, readers compute their own");
}

void add_how(Arguments& arguments, ConversionRequest& request, Words& words) {
  ModelSettings& model = request.model;
  arguments.add("--up", words.up, "AXIS", "Which axis points up: y or z")
      .one_of({"y", "z"})
      .with_default_shown();
  arguments.add("--unit", words.unit, "UNIT", "What a coordinate of 1 means: m or cm")
      .one_of({"m", "cm"})
      .with_default_shown();
  arguments.add("--scale", model.placement.scale, {1e-6, 1e6}, "X",
                "Makes everything X times as large");
  arguments.add("--max-error", request.max_error_m, {ConversionRequest::least_max_error_m, 1}, "M",
                "Of a recording: how far coordinates may be from the truth, in metres");
  arguments.add("--fps", model.frames_per_second, {1e-3, 1e6}, "RATE",
                "Frames a second that the files state, whatever the recording's were");
}

// Numbers that may be left out.
struct MayBeGiven {
  Argument start_frame;
  Argument tolerance;
};

Argument add_verification(Arguments& arguments, CommandLine& line, Words& words) {
  const auto verify =
      arguments.flag("--verify", line.verify,
                     "Read the files back by other code and compare them with the recording");
  arguments
      .flag("--verify-only", line.verify_only,
            "The same with files that are there already; write nothing")
      .excludes(verify);
  return arguments.add("--tolerance", words.tolerance_m, {0, 1000}, "M",
                       "How far a vertex may be off, in recorded metres (default: as far as the "
                       "format rounds)");
}

Argument add_files(Arguments& arguments, CommandLine& line, Words& words) {
  const auto start =
      arguments.add("--start-frame", words.start_frame, {0, 100'000'000}, "N",
                    "Number of the first file; the others follow (default: as recorded)");
  const auto force =
      arguments.flag("--force", line.request.force, "Replace files that exist already");
  arguments
      .flag("--resume", line.request.resume,
            "Go on with a sequence that was stopped: files that are complete stay")
      .excludes(force);
  arguments.flag("--dry-run", line.dry_run, "Tell files, size and time, and write nothing");
  arguments.add("--threads", line.threads, {1, 1024}, "N",
                "How many threads to use (default: all cores)");
  arguments.add_progress(words.progress);
  arguments.flag("--quiet", line.quiet, "No progress and no summary");
  return start;
}

MayBeGiven add_options(Arguments& arguments, CommandLine& line, Words& words) {
  ConversionRequest& request = line.request;
  arguments
      .add("recording", request.recording, "KNOT.rbn", "The recording, as ribbon-record wrote it")
      .required();
  arguments
      .add("-o,--output", request.output, "FILE",
           "Where to: .obj or .fbx with {frame} or {frame:04} for the number; all frames as .abc, "
           ".fbx, .glb, .usda, .mdd, .pc2 or .npy; their numbers as .csv; or .rbn")
      .required();
  add_what(arguments, request, words);
  add_how(arguments, request, words);
  const Argument tolerance = add_verification(arguments, line, words);
  return {.start_frame = add_files(arguments, line, words), .tolerance = tolerance};
}

void apply(const Words& words, ModelSettings& model) {
  model.faces = words.faces == "quads" ? RibbonFaces::quads : RibbonFaces::triangles;
  model.with_ribbon = words.objects != "obstacle";
  model.with_obstacle = words.objects != "ribbon";
  model.placement.up = words.up == "z" ? UpAxis::z : UpAxis::y;
  model.placement.metres_per_unit = words.unit == "cm" ? 0.01 : 1;
}

}  // namespace

Result<std::optional<CommandLine>> parse_command_line(int argc, const char* const* argv) {
  Arguments arguments("ribbon-convert", "Writes a recording as files for modelling packages.",
                      RIBBON_VERSION, examples);
  CommandLine line;
  Words words;
  const MayBeGiven given = add_options(arguments, line, words);
  const auto read = arguments.parse(argc, argv);
  if (!read) return tl::unexpected(read.error());
  if (!*read) return std::nullopt;
  apply(words, line.request.model);
  line.request.progress = progress_style(words.progress, line.quiet);
  if (given.start_frame.is_given()) line.request.start_frame = words.start_frame;
  if (given.tolerance.is_given()) line.tolerance_m = words.tolerance_m;
  return line;
}

}  // namespace ribbon

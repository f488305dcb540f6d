#include "recorder/options.h"

#include "commandline/arguments.h"

namespace ribbon {

namespace {

constexpr const char* examples = R"(Examples:
  ribbon-record knot.toml -o knot.rbn
      fastens the ribbon of the scene and records it
  ribbon-record knot.toml -o knot.rbn --quiet --stats knot.json
      without progress and summary; figures of the run go to a file
  ribbon-record --resume knot.rbn
      goes on with a run that was stopped or killed, as if it had not been
  ribbon-record --resume knot.rbn --until 60
      extends a recording to one minute of simulated time
  ribbon-record knot.toml --set fastening.speed=1 --set accuracy=fine -o fine.rbn
      records the scene with other settings than it has
  ribbon-record --from 200 --set fastening.speed=1 -o fast.rbn knot.rbn
      takes frames 1 to 200 of knot.rbn over and goes on with another speed
  ribbon-record knot.toml --crossings knot.svg
      draws the knot with its passages numbered, prints their list and which knot it is
  ribbon-record --draw -o sketch.html
      writes a page in which knots are drawn and tied in any browser
Ctrl-C ends the run early and leaves a valid recording of what was done; --resume goes on with it.

Exit codes: 0 done, 2 could not, 3 ended early (by Ctrl-C, a signal, or because the disk was full):
--resume goes on with it.)";

// The words of the command line that were used.
struct Given {
  bool input, output, resume, from, set, force, crossings, draw, statistics;
  bool of_runs;  // any that only a run can follow
};

Result<void> refuse(const std::string& problem, const std::string& remedy) {
  return failure("", problem, remedy);
}

Result<void> goes_with_draw(const Given& given) {
  if (given.resume || given.from || given.crossings || given.of_runs)
    return refuse("--draw writes a page and records nothing",
                  "name a scene or none, and a page after -o");
  if (given.set && !given.input)
    return refuse("--set changes a scene, and there is none", "name one before --draw");
  if (!given.output)
    return refuse("--draw needs a page to write", "write for example '-o sketch.html'");
  return {};
}

Result<void> goes_together(const Given& given) {
  if (given.draw) return goes_with_draw(given);
  if (given.crossings && (given.output || given.resume || given.from))
    return refuse("--crossings shows the drawing of a scene and records nothing",
                  "name the scene, and record it without --crossings");
  if (given.crossings && given.of_runs)
    return refuse("--crossings runs nothing that a limit or figures could be of", "leave them out");
  if (given.crossings && given.input) return {};
  if (given.resume && given.from)
    return refuse("--resume and --from cannot go together",
                  "--resume goes on in the same file, --from begins another one");
  if (given.resume && given.output)
    return refuse("--resume goes on in the recording itself, --output names another one",
                  "leave --output out, or branch a new take off with --from");
  if (given.resume && given.input)
    return refuse("--resume takes the scene from the recording", "leave the scene out");
  if (given.resume && given.set)
    return refuse("--resume goes on with the settings that the run has",
                  "branch a new take off with --from");
  if (given.resume && given.force && !given.statistics)
    return refuse("--resume replaces nothing that --force could be of", "leave --force out");
  if (!given.resume && !given.input)
    return given.from ? refuse("--from needs a recording to branch off", "name it at the end")
                      : refuse("there is no scene to record", "name one, or see --help");
  if (!given.resume && !given.output)
    return refuse("--output is required", "write for example '-o knot.rbn'");
  return {};
}

}  // namespace

Result<std::optional<RecorderOptions>> parse_recorder_options(int argc, const char* const* argv) {
  RecorderOptions options;
  Arguments arguments("ribbon-record", "Fastens the ribbon of a scene and records every frame.",
                      RIBBON_VERSION, examples);
  const auto input = arguments.add("SCENE", options.input, "FILE",
                                   "the scene (.toml); with --from, the recording (.rbn)");
  const auto output = arguments.add("-o,--output", options.recording, "FILE",
                                    "the recording to write (.rbn), with --draw the page (.html)");
  std::filesystem::path resumed;
  const auto resume = arguments.add("--resume", resumed, "FILE",
                                    "go on with the run of this recording, in the same file");
  double until_s = 0;
  const auto until =
      arguments.add("--until", until_s, {1e-9, 1e9}, "SECONDS",
                    "end at this simulated time, before or beyond the scene's duration");
  int frame_count = 0;
  const auto frames = arguments
                          .add("--frames", frame_count, {2, 1'000'000'000}, "N",
                               "end when the recording holds so many frames")
                          .excludes(until);
  int from_frame = 1;
  const auto from = arguments.add("--from", from_frame, {1, 1'000'000'000}, "FRAME",
                                  "branch a new take off at this frame of a recording (from 1)");
  const auto set = arguments.add("--set", options.settings, "KEY=VALUE",
                                 "change this setting of the scene; may be repeated");
  const auto force =
      arguments.flag("--force", options.force, "replace a recording, or figures, of that name");
  const auto crossings = arguments.add(
      "--crossings", options.diagram, "FILE",
      "write the scene's drawing with its passages numbered (.svg), and record nothing");
  bool draws = false;
  const auto draw = arguments.flag(
      "--draw", draws,
      "write a page in which one draws a knot, round the scene's object if one is named, and ties "
      "it");
  const auto statistics =
      arguments.add("--stats", options.statistics, "FILE", "JSON file for the figures of the run");
  arguments.add("--threads", options.threads, {1, 1024}, "N",
                "use at most this many threads (default: all cores); the recording is the same");
  const auto profile =
      arguments.flag("--profile", options.profile, "print where the time of the run went");
  std::string progress = "line";
  arguments.add_progress(progress);
  arguments.flag("--quiet", options.quiet, "no progress and no summary");
  const auto read = arguments.parse(argc, argv);
  if (!read) return tl::unexpected(read.error());
  if (!*read) return std::nullopt;
  const Given given{.input = input.is_given(),
                    .output = output.is_given(),
                    .resume = resume.is_given(),
                    .from = from.is_given(),
                    .set = set.is_given(),
                    .force = force.is_given(),
                    .crossings = crossings.is_given(),
                    .draw = draw.is_given(),
                    .statistics = statistics.is_given(),
                    .of_runs = until.is_given() || frames.is_given() || statistics.is_given() ||
                               profile.is_given()};
  options.progress = progress_style(progress, options.quiet);
  if (until.is_given()) options.limit.until_s = until_s;
  if (frames.is_given()) options.limit.frames = frame_count;
  if (auto together = goes_together(given); !together) return tl::unexpected(together.error());
  if (given.draw) {
    options.task = RecorderTask::draw;
  } else if (given.resume) {
    options.task = RecorderTask::resume;
    options.recording = resumed;
  } else if (given.from) {
    options.task = RecorderTask::branch;
    options.from_frame = from_frame - 1;
  } else if (given.crossings) {
    options.task = RecorderTask::crossings;
  }
  return options;
}

}  // namespace ribbon

#include "player/options.h"

#include <CLI/CLI.hpp>
#include <charconv>

#include "commandline/arguments.h"

namespace ribbon {

namespace {

constexpr int smallest_side = 16;
constexpr int largest_side = 16384;

constexpr const char* examples = R"(Examples:
  ribbon-play knot.rbn -o 'frames/{frame:04}.png'
      renders every frame into frames/0001.png, frames/0002.png, ...
  ribbon-play knot.rbn -o 'still.{frame}.png' --frames -1 --size 1920x1080 --samples 64
      renders the last frame, large and smooth
  ribbon-play knot.rbn --sheet sheet.png --frames 1:-1:50
      puts frames on one sheet, seen from two sides, with their numbers
  ribbon-play knot.rbn --info
      tells what the recording holds; --json tells it to programs
  ribbon-play knot.rbn --follow
      tells of each frame of a recording that is being written, until it ends
  ribbon-play knot.rbn --verify
      proves of every frame that nothing intersects, measures gaps and strain, certifies the knot

Exit codes: 0 done, 1 the recording is damaged (what is readable has been rendered, lost frames are
listed) or --verify found something wrong, 2 could not.)";

bool read_side(std::string_view text, int& side) {
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, side);
  return problem == std::errc() && stop == end && side >= smallest_side && side <= largest_side;
}

Result<PictureSize> parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  PictureSize size;
  if (cross == std::string::npos || !read_side(text.substr(0, cross), size.width) ||
      !read_side(text.substr(cross + 1), size.height))
    return failure("--size " + text, "is not a picture size",
                   "write WIDTHxHEIGHT, each from " + std::to_string(smallest_side) + " to " +
                       std::to_string(largest_side) + ", as in 1280x720");
  return size;
}

void add_options(CLI::App& app, Options& options, std::string& size) {
  app.add_option("RECORDING", options.recording, "the recording (.rbn)")
      ->required()
      ->type_name("FILE");
  auto* pictures =
      app.add_option("-o,--output", options.pictures,
                     "PNG files to write, with {frame} or {frame:04} for the frame's number")
          ->type_name("PATTERN");
  auto* frames = app.add_option("--frames", options.frames,
                                "frames A to B, every STEP-th; -1 is the last (default: all)")
                     ->type_name("A:B:STEP");
  app.add_option("--size", size, "size of the pictures in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  app.add_option("--samples", options.samples, "samples per pixel: more is smoother and slower")
      ->check(CLI::Range(1, 4096).description(""))
      ->type_name("N")
      ->capture_default_str();
  auto* sheet = app.add_option("--sheet", options.sheet,
                               "contact sheet to write: several frames, two cameras, captions")
                    ->type_name("FILE");
  auto* info = app.add_flag("--info", options.info, "tell what the recording holds");
  auto* verify = app.add_flag("--verify", options.verify,
                              "prove that nothing intersects and that the knot stays the knot")
                     ->excludes(pictures)
                     ->excludes(sheet)
                     ->excludes(info);
  auto* follow = app.add_flag("--follow", options.follow,
                              "go on with what is recorded meanwhile, until the recorder ends")
                     ->excludes(frames)
                     ->excludes(sheet)
                     ->excludes(verify);
  app.add_option("--certify-every", options.certify_every,
                 "certify the knot in every N-th frame, the first and the last")
      ->check(CLI::Range(1, 1'000'000'000).description(""))
      ->needs(verify)
      ->type_name("N")
      ->capture_default_str();
  app.add_flag("--json", options.json, "tell it, or report what --verify found, as JSON")
      ->excludes(follow);
  app.add_option("--threads", options.threads, "use at most this many threads (default: all cores)")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N");
  app.add_flag("--quiet", options.quiet, "no progress and no summary");
}

}  // namespace

Result<std::optional<Options>> parse_options(int argc, const char* const* argv) {
  Options options;
  std::string size = "1280x720";
  CLI::App app("Renders a recorded ribbon into pictures, tells what it holds, verifies it.",
               "ribbon-play");
  app.set_version_flag("--version", "ribbon-play " RIBBON_VERSION);
  app.footer(examples);
  add_options(app, options, size);
  const auto read = parse_arguments(app, argc, argv);
  if (!read) return tl::unexpected(read.error());
  if (!*read) return std::nullopt;
  const auto parsed = parse_size(size);
  if (!parsed) return tl::unexpected(parsed.error());
  options.size = *parsed;
  if (options.pictures.empty() && options.sheet.empty() && !options.info && !options.json &&
      !options.verify && !options.follow)
    return failure("", "nothing to do",
                   "ask for pictures (-o), a --sheet, --info, --follow or --verify");
  return options;
}

}  // namespace ribbon

#include "player/options.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "commandline/arguments.h"
#include "commandline/extension.h"
#include "files/files.h"
#include "player/job_options.h"
#include "player/look_options.h"
#include "player/order_options.h"
#include "player/preview_options.h"
#include "text/number_in.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr int smallest_side = 16;
constexpr int largest_side = 16384;

constexpr const char* examples = R"(Examples:
  ribbon-play knot.rbn -o 'frames/{frame:04}.png'
      renders every frame into frames/0001.png, frames/0002.png, ...
  ribbon-play knot.rbn -o last.png --frames -1 --size 1920x1080 --quality final
      renders the last frame, large and smooth
  ribbon-play knot.rbn -o '{view}/{frame:04}.png' --view front --view knot
      the same frames from two cameras, the second framed on the knot and following it
  ribbon-play knot.rbn -o turn.mp4 --frames -1 --turns 1 --hold 8s
      a turntable: the camera goes once round the last frame, in eight seconds
  ribbon-play knot.rbn -o knot.mp4 --fps 30
      a video, by ffmpeg; also .webm and .gif
  ribbon-play knot.rbn -o 'frames/{frame:04}.png' --resume --shard 2/8 --isa avx2
      the second of eight machines; run again, it renders what is missing
  ribbon-play knot.rbn -o 'preview/{frame:04}.png' --preview
      draws every frame at the speed of replay
  ribbon-play knot.rbn --sheet sheet.png --frames 1:-1:30
      puts every thirtieth frame on one sheet (twelve at most), seen from two sides
  ribbon-play knot.rbn -o last.png --frames -1 --color-by strain --overlay wireframe,time
      shows how far the cloth is stretched, its mesh and the time
  ribbon-play knot.rbn --plot knot.svg
      draws charts over time: strain, tightness, pull, contact
  ribbon-play knot.rbn -o knot.html
      a page that plays the recording in any browser, turned and zoomed by hand: one file
  ribbon-play knot.rbn --info
      tells what the recording holds; --json tells it to programs
  ribbon-play knot.rbn --follow
      tells of each frame of a recording that is being written, until it ends
  ribbon-play knot.rbn --verify
      proves of every frame that nothing intersects and that gaps and strain are as stated,
      certifies the knot
  ribbon-play bow.rbn --verify --between tip-left tip-right
      certifies, too, what is knotted between the tips of the loops: a reef knot, not a granny

Exit codes: 0 done, 1 the recording is damaged (what is readable has been rendered, lost frames are
listed) or --verify found something wrong, 2 could not, 3 interrupted, or the disk was full:
try again.)";

bool read_side(std::string_view text, int& side) {
  side = number_in<int>(text).value_or(0);
  return side >= smallest_side && side <= largest_side;
}

Result<PictureSize> parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  PictureSize size;
  if (cross == std::string::npos || !read_side(text.substr(0, cross), size.width) ||
      !read_side(text.substr(cross + 1), size.height))
    return failure("--size " + text, "is not a picture size",
                   filled_in("write WIDTHxHEIGHT, each from {} to {}, as in 1280x720",
                             smallest_side, largest_side));
  return size;
}

// What is read as text and understood afterwards.
struct Texts {
  std::string size = "1280x720";
  std::vector<std::string> views;
  std::string progress = "line";
  std::string shard;
  LookTexts look;
  AppearanceTexts appearance;
  OrderTexts order;
  bool preview = false;
};

void add_view_options(Arguments& arguments, Options& options, Texts& texts, Argument sheet) {
  arguments.add("--view", texts.views, "VIEW",
                "front, top, three-quarter (default), knot, or settings as in "
                "azimuth=30,elevation=20,distance=2,lens=60,subject=knot; may be repeated");
  arguments
      .add("--turns", options.turns, {-1000, 1000}, "N",
           "turn the camera N times round the scene while the pictures are taken")
      .excludes(sheet);
  arguments
      .add("--camera-path", options.camera_path, "FILE",
           "keyframes: a table with the columns time and any of azimuth, elevation, distance, "
           "lens, x, y, z")
      .excludes(sheet);
}

Result<void> check_plot(const std::filesystem::path& file) {
  const std::string ending = lower_case_extension(file);
  if (file.empty() || ending == ".svg" || ending == ".png") return {};
  return failure("--plot " + file.string(), "is neither .svg nor .png",
                 "let the name end in one of them");
}

Result<void> check_sheet(const std::filesystem::path& file) {
  if (file.empty() || lower_case_extension(file) == ".png") return {};
  return failure("--sheet " + file.string(), "is no .png", "let the name end in it");
}

// Files to write are not one another's.
Result<void> check_names(const Options& options) {
  const std::filesystem::path pictures = options.pictures == "-" ? "" : options.pictures;
  std::vector<std::filesystem::path> named;
  for (const auto& file : {pictures, options.sheet, options.plot}) {
    if (file.empty()) continue;
    for (const auto& other : named)
      if (is_same_file(file, other))
        return failure(file.string(), "is the name of two files", "name one of them otherwise");
    named.push_back(file);
  }
  return {};
}

// Raw frames are alone on standard output.
Result<void> check_standard_output(const Options& options) {
  if (options.pictures != "-" || !(options.info || options.json)) return {};
  return failure(options.info ? "--info" : "--json",
                 "would stand among the raw frames on standard output (-o -)",
                 "ask for it in a call of its own, or write the pictures to files");
}

void add_job_options(Arguments& arguments, Options& options, Texts& texts, Argument follow) {
  arguments.flag("--force", options.replaceable.all, "replace files that are there");
  arguments
      .flag("--resume", options.resume, "keep pictures that are complete and were made of the same")
      .excludes(follow);
  arguments.add("--shard", texts.shard, "I/N", "part I of N of the pictures, for N machines")
      .excludes(follow);
  arguments
      .add("--isa", options.isa, "SET",
           "vector instructions of the ray tracer, sse2, avx2 or avx512: pixels depend on them "
           "(default: the best)")
      .one_of({"sse2", "avx2", "avx512"});
}

void add_options(Arguments& arguments, Options& options, Texts& texts) {
  arguments.add("RECORDING", options.recording, "FILE", "the recording (.rbn)").required();
  const auto pictures = arguments.add(
      "-o,--output", options.pictures, "PATTERN",
      "what to write: .png or .exr files, with {frame} or {frame:04} for the number (one frame "
      "needs none); a .mp4, .webm or .gif; a .html that plays the recording; or '-', raw frames on "
      "standard output");
  const auto frames = arguments.add(
      "--frames", options.frames, "1,5,A:B:STEP",
      "frames by number and from A to B, every STEP-th; -1 is the last (default: all)");
  arguments.add("--size", texts.size, "WxH", "size of the pictures in pixels").with_default_shown();
  const auto sheet = arguments.add("--sheet", options.sheet, "FILE",
                                   "contact sheet to write: several frames (all of --frames up to "
                                   "12), two cameras or those of --view, captions");
  arguments.flag("--preview", texts.preview,
                 "draw instead of ray tracing: fast, no shadows, the object as a wireframe, the "
                 "drawn curve");
  add_look_options(arguments, texts.look);
  add_view_options(arguments, options, texts, sheet);
  add_appearance_options(arguments, texts.appearance);
  const auto plot = arguments.add("--plot", options.plot, "FILE",
                                  "charts over time to write, as .svg or .png: strain, tightness, "
                                  "pull, contact, penetrations");
  const auto info = arguments.flag("--info", options.info, "tell what the recording holds");
  const auto bench =
      arguments
          .flag("--bench", options.bench,
                "measure how fast frames are read and the last one is rendered, stage by stage")
          .excludes(pictures)
          .excludes(sheet)
          .excludes(plot)
          .excludes(info)
          .excludes(frames);
  const auto verify =
      arguments
          .flag("--verify", options.verify,
                "prove that nothing intersects, that edges keep their limit of strain and "
                "that the knot stays the knot")
          .excludes(pictures)
          .excludes(sheet)
          .excludes(plot)
          .excludes(info)
          .excludes(bench);
  const auto follow = arguments
                          .flag("--follow", options.follow,
                                "go on with what is recorded meanwhile, until the recorder ends")
                          .excludes(frames)
                          .excludes(sheet)
                          .excludes(plot)
                          .excludes(bench)
                          .excludes(verify);
  arguments
      .add("--certify-every", options.certify_every, {1, 1'000'000'000}, "N",
           "certify the knot in every N-th frame, the first and the last")
      .needs(verify)
      .with_default_shown();
  arguments
      .add("--between", options.between, "PLACE PLACE",
           "certify the knot of a part of the ribbon, too, as that between the loops of a bow: "
           "marks "
           "of the drawing, or shares of its length from 0 to 1")
      .needs(verify);
  arguments.flag("--json", options.json, "tell it, or report what --verify found, as JSON")
      .excludes(bench)
      .excludes(follow);
  arguments.add("--threads", options.threads, {1, 1024}, "N",
                "use at most this many threads (default: all cores)");
  arguments.add_progress(texts.progress);
  arguments.flag("--quiet", options.quiet, "no progress and no summary");
  add_order_options(arguments, texts.order, pictures, follow);
  add_job_options(arguments, options, texts, follow);
}

// Several machines must not mix pixels of different instructions.
Result<Shard> read_shard(const std::string& text, const std::string& isa) {
  if (text.empty()) return Shard{};
  auto shard = parse_shard(text);
  if (shard && shard->parts > 1 && isa.empty())
    return failure("--shard " + text, "leaves open which pixels the machines make",
                   "add --isa avx2, or --isa sse2 where one of them has no AVX2");
  return shard;
}

std::vector<std::filesystem::path> files_read(const Options& options, const LookTexts& look) {
  std::vector<std::filesystem::path> files{options.recording, look.texture, look.texture_back,
                                           look.environment, options.camera_path};
  std::erase(files, std::filesystem::path());
  return files;
}

// Puts what a text stands for where it belongs.
template <class Value>
Result<void> take(Result<Value> read, Value& value) {
  if (!read) return tl::unexpected(read.error());
  value = std::move(*read);
  return {};
}

Result<void> understand(const Texts& texts, Options& options) {
  options.progress = progress_style(texts.progress, options.quiet);
  options.replaceable.never = files_read(options, texts.look);
  return check_job_options(options.given)
      .and_then([&] { return take(parse_size(texts.size), options.size); })
      .and_then([&] { return take(read_look(texts.look), options.render); })
      .and_then([&] { return take(parse_views(texts.views), options.views); })
      .and_then([&] { return take(read_order(texts.order), options.order); })
      .and_then([&] {
        return take(parse_appearance(texts.appearance, options.follow), options.appearance);
      })
      .and_then([&]() -> Result<void> {
        if (!texts.preview) return {};
        return take(read_preview(options, texts.look.samples), options.preview.emplace());
      })
      .and_then([&] { return take(read_shard(texts.shard, options.isa), options.shard); })
      .and_then([&] { return check_sheet(options.sheet); })
      .and_then([&] { return check_plot(options.plot); })
      .and_then([&] { return check_names(options); })
      .and_then([&] { return check_standard_output(options); });
}

}  // namespace

Result<std::optional<Options>> parse_player_options(int argc, const char* const* argv) {
  Options options;
  Texts texts;
  Arguments arguments("ribbon-play",
                      "Renders a recorded ribbon into pictures, tells what it holds, verifies it.",
                      RIBBON_VERSION, examples);
  add_options(arguments, options, texts);
  const auto read = arguments.parse(argc, argv);
  if (!read) return tl::unexpected(read.error());
  if (!*read) return std::nullopt;
  options.given = arguments.given();
  return understand(texts, options).map([&] { return std::optional(std::move(options)); });
}

}  // namespace ribbon

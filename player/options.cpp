#include "player/options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <utility>

#include "commandline/arguments.h"
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
  ribbon-play knot.rbn -o knot.mp4 --fps 30
      a video, by ffmpeg; also .webm and .gif
  ribbon-play knot.rbn -o 'frames/{frame:04}.png' --resume --shard 2/8 --isa avx2
      the second of eight machines; run again, it renders what is missing
  ribbon-play knot.rbn -o 'preview/{frame:04}.png' --preview
      draws every frame at the speed of replay
  ribbon-play knot.rbn --sheet sheet.png --frames 1:-1:50
      puts frames on one sheet, seen from two sides, with their numbers
  ribbon-play knot.rbn -o last.png --frames -1 --color-by strain --overlay wireframe,time
      shows how far the cloth is stretched, its mesh and the time
  ribbon-play knot.rbn --plot knot.svg
      draws charts over time: strain, tightness, pull, contact
  ribbon-play knot.rbn --info
      tells what the recording holds; --json tells it to programs
  ribbon-play knot.rbn --follow
      tells of each frame of a recording that is being written, until it ends
  ribbon-play knot.rbn --verify
      proves of every frame that nothing intersects and that gaps and strain are as stated,
      certifies the knot

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
                   filled_in("write WIDTHxHEIGHT, each from {} to {}, as in 1280x720",
                             smallest_side, largest_side));
  return size;
}

// What is read as text and understood afterwards.
struct Texts {
  std::string size = "1280x720";
  std::vector<std::string> views;
  std::string quality = "standard";
  int samples = 0;   // 0: as the quality says
  double noise = 0;  // likewise
  std::string progress = "line";
  std::string shard;
  double frames_per_second = 0;  // 0: as recorded
  double thickness_mm = 0;
  std::filesystem::path texture;
  std::filesystem::path texture_back;
  std::filesystem::path environment;
  double sun = 1;
  double exposure = 0;
  std::string tone = "linear";
  AppearanceTexts appearance;
  bool preview = false;
};

void add_quality_options(Arguments& arguments, Texts& texts) {
  arguments
      .add("--quality", texts.quality, "NAME",
           "draft (sun and its shadow), standard (and what the sky cannot reach), final (and light "
           "from cloth to cloth)")
      .one_of({"draft", "standard", "final"})
      .with_default_shown();
  const auto samples = arguments.add(
      "--samples", texts.samples, {1, 4096}, "N",
      "samples in every pixel, whatever the quality says; no smoothing (of a preview 1, or "
      "with more than 1 always 4)");
  arguments
      .add(
          "--noise", texts.noise, {0.01, 100}, "X",
          "samples until the estimated error of each region is below X levels of 255; no smoothing")
      .excludes(samples);
}

void add_look_options(Arguments& arguments, Options& options, Texts& texts) {
  const auto texture = arguments.add(
      "--texture", texts.texture, "FILE",
      "PNG on the cloth instead of the built-in pattern: as high as the ribbon is wide, repeated");
  arguments.add("--texture-back", texts.texture_back, "FILE", "PNG on its back (default: the same)")
      .needs(texture);
  arguments.add("--thickness", texts.thickness_mm, {0, 1000}, "MM",
                "of the cloth, as it is seen at the selvages; layers that are pressed together get "
                "less (default: 0)");
  arguments.flag("--ground", options.render.ground, "a floor that shows the shadows");
  arguments.add("--environment", texts.environment, "FILE",
                "PNG of a panorama, whose light takes the place of the even sky's");
  arguments.add("--sun", texts.sun, {0, 100}, "X", "the sun X times as bright; 0: none")
      .with_default_shown();
  arguments
      .add("--exposure", texts.exposure, {-10, 10}, "STOPS",
           "each doubles the light of the picture")
      .with_default_shown();
  arguments
      .add("--tone", texts.tone, "NAME",
           "linear: what is brighter than white is cut off; soft: it comes ever closer to white")
      .one_of({"linear", "soft"})
      .with_default_shown();
}

Result<std::shared_ptr<const Texture>> texture_of(const std::filesystem::path& file) {
  if (file.empty()) return nullptr;
  return Texture::read(file).map(
      [](Texture&& texture) { return std::make_shared<const Texture>(std::move(texture)); });
}

Result<Lighting> lighting_of(const Texts& texts) {
  Lighting lighting;
  lighting.sun *= static_cast<float>(texts.sun);
  if (texts.environment.empty()) return lighting;
  auto panorama = Texture::read(texts.environment);
  if (!panorama) return tl::unexpected(panorama.error());
  lighting.environment = std::make_shared<const Environment>(std::move(*panorama));
  return lighting;
}

Result<Cloth> cloth_of(const Texts& texts) {
  auto front = texture_of(texts.texture);
  if (!front) return tl::unexpected(front.error());
  auto back = texture_of(texts.texture_back);
  if (!back) return tl::unexpected(back.error());
  return Cloth{std::move(*front), std::move(*back)};
}

constexpr int most_samples_for_noise = 4096;

Quality quality_of(const Texts& texts) {
  Quality quality = *quality_named(texts.quality);
  if (texts.samples == 0 && texts.noise == 0) return quality;
  quality.smooth_sky = false;
  quality.noise = static_cast<float>(texts.noise);
  if (texts.samples > 0)
    quality.samples = quality.most_samples = texts.samples;
  else
    quality.most_samples = most_samples_for_noise;
  return quality;
}

void add_appearance_options(Arguments& arguments, AppearanceTexts& texts) {
  const auto color_by = arguments
                            .add("--color-by", texts.color_by, "QUANTITY",
                                 "colour the ribbon by strain, speed, contact or gap, with a "
                                 "legend (default: its cloth)")
                            .one_of({quantity_words.begin(), quantity_words.end()});
  arguments
      .add("--color-range", texts.color_range, "A:B",
           "values of the first and the last colour, in the legend's unit (default: of the frames "
           "asked for)")
      .needs(color_by);
  arguments.add("--overlay", texts.overlays, "WORDS",
                "draw over the pictures: some of wireframe, obstacle-wireframe, curve, frame, "
                "time, numbers, with commas between them");
}

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
  if (file.empty() || file.extension() == ".svg" || file.extension() == ".png") return {};
  return failure("--plot " + file.string(), "is neither .svg nor .png",
                 "let the name end in one of them");
}

// What only the ray tracer does; machines of different makers may draw previews differently.
constexpr std::array without_preview{"--quality",   "--noise",  "--texture",     "--texture-back",
                                     "--thickness", "--ground", "--environment", "--sun",
                                     "--exposure",  "--tone",   "--color-by",    "--shard",
                                     "--isa",       "--bench"};

Result<void> check_preview(const std::vector<GivenArgument>& given, const Overlays& overlays) {
  const auto refuse = [](const std::string& other) {
    return failure("--preview", "does not go with " + other, "leave one of them out");
  };
  for (const GivenArgument& argument : given)
    if (std::find(without_preview.begin(), without_preview.end(), argument.name) !=
        without_preview.end())
      return refuse(argument.name);
  if (overlays.wireframe || overlays.obstacle_wireframe) return refuse("wireframe overlays");
  return {};
}

void add_order_options(Arguments& arguments, Options& options, Texts& texts, Argument pictures,
                       Argument follow) {
  arguments.flag("--reverse", options.order.reverse, "play backwards")
      .needs(pictures)
      .excludes(follow);
  arguments.flag("--ping-pong", options.order.ping_pong, "play there and back, to be repeated")
      .needs(pictures)
      .excludes(follow);
  arguments
      .add("--fps", texts.frames_per_second, {1e-3, 1e4}, "RATE",
           "so many pictures a second, each of the nearest recorded frame; also of a video "
           "(default: as recorded)")
      .needs(pictures)
      .excludes(follow);
}

void add_job_options(Arguments& arguments, Options& options, Texts& texts, Argument follow) {
  arguments.flag("--force", options.force, "replace files that are there");
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
      "needs none); a .mp4, .webm or .gif; or '-', raw frames on standard output");
  const auto frames = arguments.add(
      "--frames", options.frames, "1,5,A:B:STEP",
      "frames by number and from A to B, every STEP-th; -1 is the last (default: all)");
  arguments.add("--size", texts.size, "WxH", "size of the pictures in pixels").with_default_shown();
  const auto sheet = arguments.add("--sheet", options.sheet, "FILE",
                                   "contact sheet to write: several frames, two cameras, captions");
  arguments.flag("--preview", texts.preview,
                 "draw instead of ray tracing: fast, no shadows, the object as a wireframe, the "
                 "drawn curve");
  add_quality_options(arguments, texts);
  add_look_options(arguments, options, texts);
  add_view_options(arguments, options, texts, sheet);
  add_appearance_options(arguments, texts.appearance);
  const auto plot = arguments.add("--plot", options.plot, "FILE",
                                  "charts over time to write, as .svg or .png: strain, tightness, "
                                  "pull, contact, penetrations");
  const auto info = arguments.flag("--info", options.info, "tell what the recording holds");
  arguments
      .flag("--bench", options.bench,
            "measure how fast frames are read and the last one is rendered, stage by stage")
      .excludes(pictures)
      .excludes(sheet)
      .excludes(frames);
  const auto verify =
      arguments
          .flag("--verify", options.verify,
                "prove that nothing intersects, that edges keep their limit of strain and "
                "that the knot stays the knot")
          .excludes(pictures)
          .excludes(sheet)
          .excludes(plot)
          .excludes(info);
  const auto follow = arguments
                          .flag("--follow", options.follow,
                                "go on with what is recorded meanwhile, until the recorder ends")
                          .excludes(frames)
                          .excludes(sheet)
                          .excludes(plot)
                          .excludes(verify);
  arguments
      .add("--certify-every", options.certify_every, {1, 1'000'000'000}, "N",
           "certify the knot in every N-th frame, the first and the last")
      .needs(verify)
      .with_default_shown();
  arguments.flag("--json", options.json, "tell it, or report what --verify found, as JSON")
      .excludes(follow);
  arguments.add("--threads", options.threads, {1, 1024}, "N",
                "use at most this many threads (default: all cores)");
  arguments.add_progress(texts.progress);
  arguments.flag("--quiet", options.quiet, "no progress and no summary");
  add_order_options(arguments, options, texts, pictures, follow);
  add_job_options(arguments, options, texts, follow);
}

}  // namespace

Result<std::optional<Options>> parse_options(int argc, const char* const* argv) {
  Options options;
  Texts texts;
  Arguments arguments("ribbon-play",
                      "Renders a recorded ribbon into pictures, tells what it holds, verifies it.",
                      RIBBON_VERSION, examples);
  add_options(arguments, options, texts);
  const auto read = arguments.parse(argc, argv);
  if (!read) return tl::unexpected(read.error());
  if (!*read) return std::nullopt;
  const auto size = parse_size(texts.size);
  if (!size) return tl::unexpected(size.error());
  options.size = *size;
  options.render.quality = quality_of(texts);
  auto cloth = cloth_of(texts);
  if (!cloth) return tl::unexpected(cloth.error());
  options.render.cloth = std::move(*cloth);
  auto lighting = lighting_of(texts);
  if (!lighting) return tl::unexpected(lighting.error());
  options.render.lighting = std::move(*lighting);
  options.render.tone = {static_cast<float>(texts.exposure), texts.tone == "soft"};
  options.render.thickness_m = static_cast<float>(texts.thickness_mm / 1000);
  auto views = parse_views(texts.views);
  if (!views) return tl::unexpected(views.error());
  options.views = std::move(*views);
  if (!texts.shard.empty()) {
    const auto shard = parse_shard(texts.shard);
    if (!shard) return tl::unexpected(shard.error());
    options.shard = *shard;
    if (options.isa.empty() && shard->parts > 1)
      return failure("--shard " + texts.shard, "leaves open which pixels the machines make",
                     "add --isa avx2, or --isa sse2 where one of them has no AVX2");
  }
  if (texts.frames_per_second > 0) options.order.frames_per_second = texts.frames_per_second;
  options.progress = progress_style(texts.progress, options.quiet);
  options.given = arguments.given();
  const auto appearance = parse_appearance(texts.appearance, options.follow);
  if (!appearance) return tl::unexpected(appearance.error());
  options.appearance = *appearance;
  if (texts.preview) {
    const auto checked = check_preview(options.given, options.appearance.overlays);
    if (!checked) return tl::unexpected(checked.error());
    options.preview = {texts.samples > 1, options.threads};
  }
  if (const auto plot = check_plot(options.plot); !plot) return tl::unexpected(plot.error());
  return options;
}

}  // namespace ribbon

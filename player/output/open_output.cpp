#include "player/output/open_output.h"

#include <optional>
#include <utility>

#include "commandline/frame_pattern.h"
#include "player/output/background_sink.h"
#include "player/output/picture_files.h"
#include "player/output/raw_frames.h"
#include "player/output/video.h"

namespace ribbon {

namespace {

// One stream of pictures, which cannot be taken apart.
Result<std::unique_ptr<PictureSink>> open_stream(const OutputRequest& request,
                                                 PictureFormat format) {
  if (request.shard.parts > 1 || request.resumes)
    return failure(request.name, "holds all pictures, and cannot be written in parts",
                   "write pictures (.png) where --shard or --resume is needed");
  if (format == PictureFormat::raw) return RawFrames::open(request.stopped);
  if (auto single = check_single_name(request.name); !single) return tl::unexpected(single.error());
  return Video::open(request.name, request.size, request.frames_per_second, request.replaceable,
                     request.stopped);
}

Result<Output> background(const OutputRequest& request, PictureFormat format,
                          Result<std::unique_ptr<PictureSink>> sink) {
  if (!sink) return tl::unexpected(sink.error());
  return Output{format,
                std::make_unique<BackgroundSink>(*std::move(sink)),
                {},
                0,
                format == PictureFormat::raw ? "standard output" : request.name};
}

// Where files are to be written in any case, only the manifest may know what to replace.
Result<Output> open_files(const OutputRequest& request, PictureFormat format,
                          const std::vector<PlayedFrame>& film) {
  const auto pattern = FramePattern::parse(request.name, static_cast<int>(film.size()));
  if (!pattern) return tl::unexpected(pattern.error());
  const std::vector<PlayedFrame> part = part_of(film, request.shard);
  // Otherwise before the manifest is begun.
  if (!request.resumes)
    if (auto free = check_places(part, *pattern, std::nullopt, request.replaceable); !free)
      return tl::unexpected(free.error());
  std::optional<Manifest> manifest;
  std::vector<PlayedFrame> frames = part;
  if (has_manifest(request.name, film.size(), request.resumes)) {
    auto opened = Manifest::open(*pattern, request.made_of, request.shard);
    if (!opened) return tl::unexpected(opened.error());
    manifest = *std::move(opened);
  }
  if (request.resumes) {
    frames = still_to_render(std::move(frames), *pattern, *manifest);
    if (auto free = check_places(frames, *pattern, manifest, request.replaceable); !free)
      return tl::unexpected(free.error());
  }
  const std::size_t complete = part.size() - frames.size();
  auto output = background(
      request, format,
      std::make_unique<PictureFiles>(*pattern, std::move(manifest), request.replaceable));
  if (!frames.empty()) output->last = pattern->file(frames.back().number);
  output->frames = std::move(frames);
  output->complete = complete;
  return output;
}

}  // namespace

bool has_manifest(const std::string& name, std::size_t pictures, bool resumes) {
  const auto format = picture_format(name);
  return format && is_one_file_each(*format) && (pictures > 1 || resumes);
}

Result<Output> open_output(const OutputRequest& request, const std::vector<PlayedFrame>& film) {
  const auto format = picture_format(request.name);
  if (!format) return tl::unexpected(format.error());
  if (is_one_file_each(*format)) return open_files(request, *format, film);
  auto output = background(request, *format, open_stream(request, *format));
  if (output) output->frames = film;
  return output;
}

Result<Output> open_live_output(const OutputRequest& request) {
  const auto format = picture_format(request.name);
  if (!format) return tl::unexpected(format.error());
  if (!is_one_file_each(*format))
    return background(request, *format, open_stream(request, *format));
  const auto pattern = FramePattern::parse(request.name);
  if (!pattern) return tl::unexpected(pattern.error());
  return background(request, *format,
                    std::make_unique<PictureFiles>(*pattern, std::nullopt, request.replaceable));
}

}  // namespace ribbon

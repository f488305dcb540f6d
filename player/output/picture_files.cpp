#include "player/output/picture_files.h"

#include <filesystem>
#include <string_view>
#include <utility>

#include "files/files.h"
#include "files/part_file.h"
#include "player/picture/exr_encoder.h"
#include "player/picture/png_encoder.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

std::string encoded(const OutputPicture& picture) {
  if (const auto* light = std::get_if<LightPicture>(&picture.image)) return exr_bytes(*light);
  return png_bytes(std::get<Picture>(picture.image));
}

// The manifest knows what may be replaced.
Result<void> check_place_of(const fs::path& file, int number,
                            const std::optional<Manifest>& manifest, Replaceable replaceable,
                            std::string_view other_way = "") {
  if (manifest && manifest->is_known(number)) replaceable.all = true;
  return check_place(file, replaceable, other_way);
}

}  // namespace

PictureFiles::PictureFiles(FramePattern pattern, std::optional<Manifest> manifest,
                           Replaceable replaceable)
    : pattern_(std::move(pattern)),
      manifest_(std::move(manifest)),
      replaceable_(std::move(replaceable)) {}

Result<void> PictureFiles::put(OutputPicture picture) {
  const fs::path file = pattern_.file(picture.number);
  if (auto free = check_place_of(file, picture.number, manifest_, replaceable_); !free) return free;
  const std::string bytes = encoded(picture);
  if (manifest_)
    if (auto noted = manifest_->note(picture.number, picture.frame, bytes); !noted) return noted;
  return write_file(file, bytes);
}

std::vector<PlayedFrame> still_to_render(std::vector<PlayedFrame> frames,
                                         const FramePattern& pattern, const Manifest& manifest) {
  std::vector<fs::path> pictures;
  pictures.reserve(frames.size());
  for (const PlayedFrame& frame : frames) pictures.push_back(pattern.file(frame.number));
  remove_leftovers(pictures);
  std::erase_if(frames, [&](const PlayedFrame& frame) {
    return manifest.is_complete(frame.number, frame.frame());
  });
  return frames;
}

Result<void> check_places(const std::vector<PlayedFrame>& frames, const FramePattern& pattern,
                          const std::optional<Manifest>& manifest, const Replaceable& replaceable) {
  const std::string_view other_way = manifest ? "" : ", or go on with a sequence by --resume";
  for (const PlayedFrame& frame : frames)
    if (auto free = check_place_of(pattern.file(frame.number), frame.number, manifest, replaceable,
                                   other_way);
        !free)
      return free;
  return {};
}

}  // namespace ribbon

// Pictures as files, one each.
#pragma once

#include <optional>
#include <vector>

#include "commandline/frame_pattern.h"
#include "player/output/existing_file.h"
#include "player/output/manifest.h"
#include "player/output/picture_sink.h"

namespace ribbon {

// Encodes pictures as PNG and linear light as EXR, into files that appear complete or not at all.
class PictureFiles final : public PictureSink {
 public:
  // What the manifest, if there is one, knows is replaceable, too.
  PictureFiles(FramePattern pattern, std::optional<Manifest> manifest, Replaceable replaceable);

  Result<void> put(OutputPicture picture) override;
  Result<void> finish() override { return {}; }

 private:
  FramePattern pattern_;
  std::optional<Manifest> manifest_;
  Replaceable replaceable_;
};

// Those that are still to be rendered of a sequence that goes on: all that are not complete.
// Removes what a kill has left of them under temporary names.
std::vector<PlayedFrame> still_to_render(std::vector<PlayedFrame> frames,
                                         const FramePattern& pattern, const Manifest& manifest);

// Fails where one of these would take the place of a file that is not replaceable and that the
// manifest, if there is one, does not know: to be asked before the long work that comes first.
Result<void> check_places(const std::vector<PlayedFrame>& frames, const FramePattern& pattern,
                          const std::optional<Manifest>& manifest, const Replaceable& replaceable);

}  // namespace ribbon

// What the user asked for becomes a place where pictures go.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "player/output/existing_file.h"
#include "player/output/manifest.h"
#include "player/output/picture_format.h"
#include "player/output/picture_sink.h"
#include "player/output/play_order.h"
#include "player/output/reader_pipe.h"

namespace ribbon {

struct OutputRequest {
  std::string name;  // of the pictures' files, with a place for their number; of a video; or "-"
  PictureSize size;
  double frames_per_second = 0;  // of a video
  MadeOf made_of;                // where has_manifest()
  Shard shard = {};
  bool resumes = false;  // keeps what is complete; otherwise nothing may be there but
  Replaceable replaceable = {};
  Stopped stopped = {};  // of a video or a stream; must outlive the output
};

struct Output {
  PictureFormat format = PictureFormat::png;
  std::unique_ptr<PictureSink> sink;
  std::vector<PlayedFrame> frames;  // still to be rendered, in their order
  std::size_t complete = 0;         // were there already
  std::string last;                 // file, for a summary
};

// Is there a manifest beside so many pictures of this name? A single one needs it to go on alone.
bool has_manifest(const std::string& name, std::size_t pictures, bool resumes);

// For the pictures of `film`, of which it is this shard's part that will come. A sequence of files
// gets a manifest beside it. Fails, before anything is written, where the name makes no sense or
// something is in the way.
Result<Output> open_output(const OutputRequest& request, const std::vector<PlayedFrame>& film);

// For pictures that come one by one, nobody knows how many.
Result<Output> open_live_output(const OutputRequest& request);

}  // namespace ribbon

// Watches a recording that is being written.
#pragma once

#include <functional>
#include <string>

#include "playback/recording_reader.h"
#include "result/result.h"

namespace ribbon {

struct FollowObserver {
  // For each frame, in their order, as soon as it is there: this one if it can be read...
  std::function<Result<void>(int index)> frame;
  // ... and this one if damage took it. A failure of either ends it.
  std::function<Result<void>()> lost;
  // Asked at least ten times a second.
  std::function<bool()> interrupted;
};

// Tells of every frame, those that are there and those to come, until the writer has ended, however
// it ended, or `interrupted` says so. Fails where the file becomes another recording.
Result<void> follow(RecordingReader& reader, const FollowObserver& observer);

// One frame in one line: "frame 12: 0.24 s, strain 4.1 %, penetrations 0, progress 95.0 %".
std::string frame_line(int index, const FrameNumbers& numbers);

}  // namespace ribbon

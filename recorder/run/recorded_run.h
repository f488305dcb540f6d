// A run as its recording tells it, brought back to where it can go on.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "playback/recording_reader.h"
#include "recorder/run/simulated_frames.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// In a session's settings: the run went on although the ribbon was tight.
inline constexpr std::string_view drawn_on = "time.until = \"duration\"";

struct RecordedRun {
  std::filesystem::path file;  // only in its folder can a drawing be looked for
  RecordingReader reader;
  Scene scene;  // as later sessions have extended it

  // before_frame (from 0): where the ribbon was drawn on from that frame or a later one, the scene
  // is still one that ends when it is tight.
  static Result<RecordedRun> open(const std::filesystem::path& file,
                                  std::optional<int> before_frame = std::nullopt);

  [[nodiscard]] RestSize rest_size() const;

  // The run, simulated again up to frame `index` (from 0) from the last checkpoint at or before it
  // that can be used, and else from its start, which is then generated anew from its drawing.
  // Frames on the way are compared with the recorded ones, those that are lost excepted. The
  // obstacle is the recorded one. index -1: the start, before its frame.
  //
  // Fails where the run comes out otherwise than recorded, and where there is neither a checkpoint
  // nor a drawing. Nothing where `go_on`, which is asked after each frame (how many of how many),
  // says no.
  Result<std::optional<SimulatedFrames>> simulated_again(
      int index, const std::function<bool(int done, int total)>& go_on);
};

}  // namespace ribbon

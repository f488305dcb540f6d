// What lies between recorded frames is proved by nothing: it is looked at, and told.
#pragma once

#include <optional>
#include <string>

#include "playback/between_frames.h"
#include "player/output/play_order.h"
#include "verification/frame_verifier.h"

namespace ribbon {

// The moments between recorded frames that a film shows.
struct Interpolated {
  int moments = 0;
  int intersecting = 0;
  double first_intersecting = 0;  // as frames are counted, from 1
};

// One sentence for people.
std::string sentence_on(const Interpolated& interpolated);

class InterpolationCheck {
 public:
  // Keeps a reference to `reader`.
  explicit InterpolationCheck(RecordingReader& reader) : reader_(reader), between_(reader) {}

  // Counts what `frame`, which is interpolated, shows. Fails where a frame cannot be read.
  Result<void> add(const PlayedFrame& frame, Interpolated& interpolated);

 private:
  RecordingReader& reader_;
  BetweenFrames between_;
  std::optional<FrameVerifier> verifier_;  // once there is something to verify
  Eigen::Matrix3Xf positions_;
};

}  // namespace ribbon

// Which frame stands where when a recording is played.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "result/result.h"

namespace ribbon {

// This one of that many equal parts of a job, from 1.
struct Shard {
  int part = 1;
  int parts = 1;
};

// Reads "2/8". Fails for anything that is no part.
Result<Shard> parse_shard(const std::string& text);

// How long a frame is shown.
struct Hold {
  double length = 1;        // at least one picture, however short
  bool is_seconds = false;  // otherwise pictures

  bool operator==(const Hold&) const = default;
};

// Reads "24" (pictures) or "1.5s". Fails for anything else.
Result<Hold> parse_hold(const std::string& text);

// What to do with the frames that were chosen.
struct PlayOrder {
  bool reverse = false;    // from the last to the first
  bool ping_pong = false;  // there and back, so that it can be repeated
  // Other than recorded: of each moment the nearest frame...
  std::optional<double> frames_per_second = std::nullopt;
  bool interpolates = false;  // ... or what lies between two frames
  // Each frame stands for so long, whatever time lies between them.
  std::optional<Hold> hold = std::nullopt;

  // Is a picture's place in the order something else than its frame?
  [[nodiscard]] bool renumbers() const { return reverse || ping_pong || frames_per_second || hold; }
};

// Moments that are nearer to each other, in frames, are the same.
inline constexpr double same_moment = 1e-6;

struct PlayedFrame {
  int index = 0;   // in the recording, from 0
  int number = 1;  // of the picture: in the order of playing where that renumbers, else its frame's
  double progress = 0;  // through the film: 0 at the first picture, below 1 at the last
  double after = 0;     // of the way to the recording's next frame, below 1; 0: the frame itself

  [[nodiscard]] bool is_interpolated() const { return after > 0; }
  // As users count them, from 1, and what lies between them.
  [[nodiscard]] double frame() const { return index + 1 + after; }
  bool operator==(const PlayedFrame&) const = default;
};

// `frames`: indices from 0, as far apart in time as the recording's frames are, `recorded` a
// second. Fails where the other rate, or the hold, makes too many of them.
Result<std::vector<PlayedFrame>> played_frames(std::vector<int> frames, double recorded,
                                               const PlayOrder& order);

// The part of a shard: every so-manieth, so that all take as long.
std::vector<PlayedFrame> part_of(const std::vector<PlayedFrame>& frames, const Shard& shard);

// Those of `frames` that are not lost (indices from 0; lost: ascending).
std::vector<int> readable_frames(std::vector<int> frames, const std::vector<int>& lost);

// What is lost (likewise), or lies beside what is, is left out of a film...
std::vector<PlayedFrame> without(std::vector<PlayedFrame> frames, const std::vector<int>& lost);

// ... or the frame before is held, and at the start the first one after, so that the others keep
// their time.
std::vector<PlayedFrame> held_over(std::vector<PlayedFrame> frames, const std::vector<int>& lost);

}  // namespace ribbon

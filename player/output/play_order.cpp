#include "player/output/play_order.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr double most_pictures = 1e8;

void reverse(std::vector<int>& frames) {
  std::reverse(frames.begin(), frames.end());
}

// The ends are not doubled: neither in the middle nor where it begins again.
void append_way_back(std::vector<int>& frames) {
  for (std::size_t i = frames.size(); i-- > 2;) frames.push_back(frames[i - 1]);
}

// Each moment k / rate gets the frame that is nearest to it.
Result<std::vector<int>> resampled(const std::vector<int>& frames, double recorded, double rate) {
  const double last = static_cast<double>(frames.size()) - 1;
  // A hair more, so that rounding does not lose the last moment.
  const double count = std::floor(last * rate / recorded * (1 + 1e-12)) + 1;
  if (!(count <= most_pictures))
    return failure(filled_in("--fps {:.6g}", rate),
                   filled_in("makes {:.3g} pictures of {} frames", count, frames.size()),
                   "ask for fewer a second");
  std::vector<int> nearest;
  nearest.reserve(static_cast<std::size_t>(count));
  for (double k = 0; k < count; ++k) {
    const double place = std::min(std::floor(k * recorded / rate + 0.5), last);
    nearest.push_back(frames[static_cast<std::size_t>(place)]);
  }
  return nearest;
}

bool is_in(const std::vector<int>& ascending, int index) {
  return std::binary_search(ascending.begin(), ascending.end(), index);
}

}  // namespace

Result<Shard> parse_shard(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, shard.part);
  if (first == std::errc() && slash != end && *slash == '/') {
    const auto [stop, second] = std::from_chars(slash + 1, end, shard.parts);
    if (second == std::errc() && stop == end && 1 <= shard.part && shard.part <= shard.parts)
      return shard;
  }
  return failure("--shard " + text, "is no part of a job",
                 "write I/N for part I of N, I from 1 to N, as in 2/8");
}

Result<std::vector<PlayedFrame>> played_frames(std::vector<int> frames, double recorded,
                                               const PlayOrder& order) {
  if (order.reverse) reverse(frames);
  if (order.ping_pong) append_way_back(frames);
  if (order.frames_per_second && !frames.empty()) {
    auto others = resampled(frames, recorded, *order.frames_per_second);
    if (!others) return tl::unexpected(others.error());
    frames = *std::move(others);
  }
  std::vector<PlayedFrame> played;
  played.reserve(frames.size());
  for (const int index : frames) {
    const auto place = static_cast<int>(played.size());
    played.push_back({index, order.renumbers() ? place + 1 : index + 1,
                      static_cast<double>(place) / static_cast<double>(frames.size())});
  }
  return played;
}

std::vector<PlayedFrame> part_of(const std::vector<PlayedFrame>& frames, const Shard& shard) {
  std::vector<PlayedFrame> part;
  for (std::size_t i = static_cast<std::size_t>(shard.part) - 1; i < frames.size();
       i += static_cast<std::size_t>(shard.parts))
    part.push_back(frames[i]);
  return part;
}

std::vector<int> readable_frames(std::vector<int> frames, const std::vector<int>& lost) {
  std::erase_if(frames, [&](int index) { return is_in(lost, index); });
  return frames;
}

std::vector<PlayedFrame> without(std::vector<PlayedFrame> frames, const std::vector<int>& lost) {
  std::erase_if(frames, [&](const PlayedFrame& frame) { return is_in(lost, frame.index); });
  return frames;
}

std::vector<PlayedFrame> held_over(std::vector<PlayedFrame> frames, const std::vector<int>& lost) {
  const auto readable = [&](const PlayedFrame& frame) { return !is_in(lost, frame.index); };
  const auto first = std::find_if(frames.begin(), frames.end(), readable);
  if (first == frames.end()) return {};
  int held = first->index;
  for (PlayedFrame& frame : frames) {
    if (readable(frame)) held = frame.index;
    frame.index = held;
  }
  return frames;
}

}  // namespace ribbon

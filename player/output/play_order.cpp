#include "player/output/play_order.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "text/number_in.h"
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

Result<void> check_count(const std::string& option, double count, std::size_t frames) {
  if (count <= most_pictures) return {};
  return failure(option, filled_in("makes {:.3g} pictures of {} frames", count, frames),
                 "ask for fewer");
}

// Frames as they are.
std::vector<PlayedFrame> shown(const std::vector<int>& frames) {
  std::vector<PlayedFrame> played;
  played.reserve(frames.size());
  for (const int index : frames) played.push_back({.index = index});
  return played;
}

Result<std::vector<PlayedFrame>> held(const std::vector<int>& frames, const Hold& hold,
                                      double rate) {
  const double pictures = hold.is_seconds ? std::floor(hold.length * rate + 0.5) : hold.length;
  const double each = std::max(pictures, 1.0);
  const std::string option = filled_in("--hold {:.6g}{}", hold.length, hold.is_seconds ? "s" : "");
  const double count = each * static_cast<double>(frames.size());
  if (auto few = check_count(option, count, frames.size()); !few)
    return tl::unexpected(few.error());
  std::vector<PlayedFrame> longer;
  longer.reserve(static_cast<std::size_t>(count));
  for (const int frame : frames)
    longer.insert(longer.end(), static_cast<std::size_t>(each), {.index = frame});
  return longer;
}

PlayedFrame nearest(const std::vector<int>& frames, double place) {
  return {.index = frames[static_cast<std::size_t>(std::floor(place + 0.5))]};
}

// Between two frames of the film lies what the recording has between them, be it other frames.
PlayedFrame between(const std::vector<int>& frames, double place) {
  const auto before = static_cast<std::size_t>(place);
  const std::size_t next = std::min(before + 1, frames.size() - 1);
  const double share = place - static_cast<double>(before);
  const double recorded = frames[before] + share * (frames[next] - frames[before]);
  const double frame = std::floor(recorded + same_moment);
  const double after = recorded - frame;
  return {.index = static_cast<int>(frame), .after = after < same_moment ? 0 : after};
}

// What each moment k / rate shows.
Result<std::vector<PlayedFrame>> resampled(const std::vector<int>& frames, double recorded,
                                           double rate, bool interpolates) {
  const double last = static_cast<double>(frames.size()) - 1;
  // A hair more, so that rounding does not lose the last moment.
  const double count = std::floor(last * rate / recorded * (1 + 1e-12)) + 1;
  if (auto few = check_count(filled_in("--fps {:.6g}", rate), count, frames.size()); !few)
    return tl::unexpected(few.error());
  std::vector<PlayedFrame> played;
  played.reserve(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const double place = std::min(static_cast<double>(k) * recorded / rate, last);
    played.push_back(interpolates ? between(frames, place) : nearest(frames, place));
  }
  return played;
}

Result<std::vector<PlayedFrame>> in_time(const std::vector<int>& frames, double recorded,
                                         const PlayOrder& order) {
  const double rate = order.frames_per_second.value_or(recorded);
  if (order.hold) return held(frames, *order.hold, rate);
  if (order.frames_per_second && !frames.empty())
    return resampled(frames, recorded, rate, order.interpolates);
  return shown(frames);
}

bool is_in(const std::vector<int>& ascending, int index) {
  return std::binary_search(ascending.begin(), ascending.end(), index);
}

bool is_there(const PlayedFrame& frame, const std::vector<int>& lost) {
  return !is_in(lost, frame.index) && !(frame.is_interpolated() && is_in(lost, frame.index + 1));
}

}  // namespace

Result<Shard> parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto part = number_in<int>(std::string_view(text).substr(0, slash));
    const auto parts = number_in<int>(std::string_view(text).substr(slash + 1));
    if (part && parts && 1 <= *part && *part <= *parts) return Shard{*part, *parts};
  }
  return failure("--shard " + text, "is no part of a job",
                 "write I/N for part I of N, I from 1 to N, as in 2/8");
}

Result<Hold> parse_hold(const std::string& text) {
  const bool is_seconds = text.ends_with('s');
  const auto length =
      number_in<double>(std::string_view(text).substr(0, text.size() - (is_seconds ? 1 : 0)));
  if (length && *length > 0 && std::isfinite(*length) &&
      (is_seconds || *length == std::floor(*length)))
    return Hold{*length, is_seconds};
  return failure("--hold " + text, "is no time for which a frame could stand",
                 "write a number of pictures or seconds, as in 96 or 4s");
}

Result<std::vector<PlayedFrame>> played_frames(std::vector<int> frames, double recorded,
                                               const PlayOrder& order) {
  if (order.reverse) reverse(frames);
  if (order.ping_pong) append_way_back(frames);
  auto played = in_time(frames, recorded, order);
  if (!played) return played;
  for (std::size_t place = 0; place < played->size(); ++place) {
    PlayedFrame& frame = (*played)[place];
    frame.number = order.renumbers() ? static_cast<int>(place) + 1 : frame.index + 1;
    frame.progress = static_cast<double>(place) / static_cast<double>(played->size());
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
  std::erase_if(frames, [&](const PlayedFrame& frame) { return !is_there(frame, lost); });
  return frames;
}

std::vector<PlayedFrame> held_over(std::vector<PlayedFrame> frames, const std::vector<int>& lost) {
  const auto readable = [&](const PlayedFrame& frame) { return is_there(frame, lost); };
  const auto first = std::find_if(frames.begin(), frames.end(), readable);
  if (first == frames.end()) return {};
  PlayedFrame held = *first;
  for (PlayedFrame& frame : frames) {
    if (readable(frame)) held = frame;
    frame.index = held.index;
    frame.after = held.after;
  }
  return frames;
}

}  // namespace ribbon

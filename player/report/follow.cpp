#include "player/report/follow.h"

#include <chrono>
#include <thread>

#include "inspection/tightness_progress_text.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// Shorter than anybody notices, longer than it takes to look.
constexpr std::chrono::milliseconds between_looks{50};

}  // namespace

Result<void> follow(RecordingReader& reader, const FollowObserver& observer) {
  reader.check();  // a directory would not tell which frames are lost
  int next = 0;
  while (true) {
    // Asked before looking: what was written before the writer ended is seen.
    const bool more_may_come = reader.is_being_written();
    if (auto refreshed = reader.refresh(); !refreshed) return refreshed;
    for (; next < reader.frame_count(); ++next) {
      if (observer.interrupted()) return {};
      auto told = reader.readable(next) ? observer.frame(next) : observer.lost();
      if (!told) return told;
    }
    if (!more_may_come || observer.interrupted()) return {};
    std::this_thread::sleep_for(between_looks);
  }
}

std::string frame_line(int index, const FrameNumbers& numbers) {
  std::string text =
      filled_in("frame {}: {:.2f} s, strain {:.1f} %, penetrations {}", index + 1, numbers.time_s,
                100 * numbers.worst_strain, numbers.penetrating_edges);
  if (numbers.tightness) text += ", " + tightness_progress_text(numbers.tightness->progress);
  return text;
}

}  // namespace ribbon

// A recording that is done, rewritten to be small.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "result/result.h"

namespace ribbon {

// What compaction tells while it goes on: how many frames of how many. Each returns false to give
// up. May be empty.
struct CompactionObserver {
  std::function<bool(int done, int total)> frame_written = {};
  std::function<bool(int done, int total)> frame_compared = {};
};

struct Compaction {
  int frames = 0;
  std::uint64_t bytes_before = 0;
  std::uint64_t bytes_after = 0;  // the same where it was as small already and stays as it is

  bool operator==(const Compaction&) const = default;
};

// Rewrites a recording with frames predicted from both sides (compaction_plan()): decoded, each has
// the same bits, and header, numbers, sessions and ending are the same. Of the checkpoints those
// stay that kept_checkpoints() names. The smaller one is written beside it, read again and compared
// with it frame by frame, forced to the disk and only then put in its place, in one step: whenever
// that ends early, the recording is as it was. No writer can have it meanwhile.
//
// Fails, leaving it as it is, where it is being written, is damaged, may not be written, or there
// is no room for the smaller one. Nothing where the observer gives up.
Result<std::optional<Compaction>> compact(const std::filesystem::path& recording,
                                          const CompactionObserver& observer = {});

// Of frames that have checkpoints: the first, from which any frame can be simulated again where a
// take branches off, and the last two, so that a run goes on although one of them gets damaged.
std::vector<std::uint32_t> kept_checkpoints(std::vector<std::uint32_t> frames);

}  // namespace ribbon

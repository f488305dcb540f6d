// A new take from the middle of a recorded one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recorder/run.h"
#include "recorder/run_statistics.h"
#include "result/result.h"

namespace ribbon {

struct BranchRequest {
  std::filesystem::path source;
  int frame = 0;                      // of the source, from 0: the last that is taken over
  std::vector<std::string> settings;  // "fastening.speed=0.3"
  std::filesystem::path target;
};

// Records into `target` what becomes of the run of `source` when settings change at a frame: frames
// up to it are copied, to the same decoded positions and numbers, and the simulation goes on from
// there. The header tells where it branched off and what changed. The source stays as it is.
//
// What the frames before and after have in common cannot change: the particles, the drawing, the
// obstacle, the contact, the axis, and how frames are recorded. Fails, before the target is made,
// when one of these, an unknown key or an impossible value is set, when the frame does not exist or
// frames before it are lost, and where simulated_again() does. Nothing where the observer gives up
// before the target is made.
Result<std::optional<RunStatistics>> branch(const BranchRequest& request,
                                            const std::string& program, const RunObserver& observer,
                                            const RunLimit& limit = {});

}  // namespace ribbon

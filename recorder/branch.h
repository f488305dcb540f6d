// A new take from the middle of a recorded one.
#pragma once

#include <filesystem>
#include <optional>

#include "recorder/run/new_recording.h"
#include "recorder/run/run.h"
#include "recorder/run/run_statistics.h"
#include "result/result.h"

namespace ribbon {

// Records what becomes of the run of a source when settings change at a frame (from 0): frames up
// to it are copied, to the same decoded positions and numbers, and the simulation goes on from
// there. The header tells where it branched off and what changed. The source stays as it is. A take
// lasts as long as its source was extended to; it ends when the ribbon is tight, where its scene
// says so and the source was drawn on only after that frame.
//
// What the frames before and after have in common cannot change: the particles, the drawing, the
// obstacle, the contact, the axis, and how frames are recorded. Fails, before the take's file is
// made, when one of these, an unknown key or an impossible value is set, when the frame does not
// exist or frames before it are lost, where an older file is not to be replaced, and where
// RecordedRun::simulated_again() does. Nothing where the observer gives up before the file is made.
Result<std::optional<RunStatistics>> branch(const std::filesystem::path& source, int frame,
                                            const NewRecording& take, const RunObserver& observer,
                                            const RunLimit& limit = {});

}  // namespace ribbon

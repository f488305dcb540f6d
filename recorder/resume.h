// Going on with a recording.
#pragma once

#include <filesystem>
#include <string>

#include "recorder/run/run.h"
#include "recorder/run/run_statistics.h"
#include "result/result.h"

namespace ribbon {

// Goes on with the stopped, killed or finished run of `path` to the same frames as if it had never
// stopped: to the end that its scene wants, or to the limit, which may lie beyond (a ribbon that
// was tight is then drawn on). Nothing but the recording is needed, unless it holds no usable
// checkpoint: then its drawing is looked for in its folder. Frames already there are kept.
//
// The statistics' numbers are those of the whole recording; nothing where there was nothing to add.
// Fails, leaving what is there, when the file cannot be read or written or another program is
// writing it, when the run comes out otherwise than recorded, and when the limit lies before the
// frames that are there. What the observer ends while frames are simulated again leaves all as it
// was, and ends as stopped.
Result<std::optional<RunStatistics>> resume(const std::filesystem::path& path,
                                            const std::string& program, const RunObserver& observer,
                                            const RunLimit& limit = {});

// What to say where there was nothing to add.
std::string nothing_to_add(const std::filesystem::path& path);

}  // namespace ribbon

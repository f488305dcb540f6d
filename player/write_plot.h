// A run's numbers over time as charts.
#pragma once

#include <string>
#include <vector>

#include "player/options.h"
#include "player/report/info.h"
#include "result/result.h"

namespace ribbon {

// Writes charts of `frames` (indices from 0, lost ones included) to options.plot, as SVG or PNG as
// its name says. Returns one line about it. Fails where the file cannot be written.
Result<std::string> write_plot(const RecordingInfo& info, std::vector<int> frames,
                               const Options& options);

}  // namespace ribbon

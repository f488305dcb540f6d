// Ribbons of any size in the two states that detection meets: loose at the start and tight at the
// end.
#pragma once

#include <filesystem>

#include "benchmarks/solver/detector.h"
#include "result/result.h"

namespace ribbon {

// The ribbon as generated from the scene's drawing, in another granularity.
Result<RibbonMotion> loose_ribbon(const std::filesystem::path& scene, int along, int across);

// The last frame of a recording, interpolated by cubics to another granularity.
Result<RibbonMotion> tight_ribbon(const std::filesystem::path& recording, int along, int across);

}  // namespace ribbon

// Ribbons of any size in the two states that detection meets: loose at the start and tight at the
// end.
#pragma once

#include <array>
#include <filesystem>

#include "benchmarks/solver/detector.h"
#include "result/result.h"

namespace ribbon {

struct RibbonSize {
  int across = 0;
  int along = 0;

  [[nodiscard]] int particles() const { return across * along; }
};

inline constexpr std::array<RibbonSize, 8> ribbon_sizes = {
    {{4, 300}, {8, 400}, {16, 400}, {16, 800}, {32, 800}, {32, 1600}, {64, 1600}, {64, 3200}}};

// The ribbon as generated from the scene's drawing, in another granularity.
Result<RibbonMotion> loose_ribbon(const std::filesystem::path& scene, int along, int across);

// The last frame of a recording, interpolated by cubics to another granularity.
Result<RibbonMotion> tight_ribbon(const std::filesystem::path& recording, int along, int across);

}  // namespace ribbon

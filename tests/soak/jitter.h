// The same knot, drawn with an unsteady hand.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "result/result.h"

namespace ribbon {

// The text of the scene in `file` with its drawing as points, evenly spaced and each moved by at
// most size_m in either direction, in a way that depends on seed alone and is the same on every
// machine. Hands keep their parts of the band, also those that the drawing marks. The name gets
// "-jitter-SEED". Names of other files stay as they are: the text belongs into the same folder.
// Fails when the scene does not draw its curve in an SVG file.
Result<std::string> jittered_scene(const std::filesystem::path& file, std::uint64_t seed,
                                   double size_m);

}  // namespace ribbon

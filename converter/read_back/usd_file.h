// USD's text form, as far as meshes in motion need it.
#pragma once

#include <filesystem>
#include <memory>

#include "converter/read_back/written_motion.h"

namespace ribbon {

// Meshes in the order of the file; points of the first may have time samples. Throws Spoiled,
// also where the text is not of the form's grammar.
std::unique_ptr<WrittenMotion> read_usd(const std::filesystem::path& path);

}  // namespace ribbon

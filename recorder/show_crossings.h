// The drawing of a scene with its passages numbered, for who writes their list.
#pragma once

#include <filesystem>
#include <string>

#include "files/part_file.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// Writes the knot diagram of the scene as an SVG file and returns what there is to say of it: the
// list for `crossings`, the Gauss code with its signs, the knot. Where over and under cannot be
// told the file shows the numbers without gaps, and then this fails with the reason and names the
// file. It fails and writes nothing where an older file is not to be replaced.
Result<std::string> show_crossings(const Scene& scene, const std::filesystem::path& file,
                                   Older older);

}  // namespace ribbon

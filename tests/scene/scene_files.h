// Scene files for tests.
#pragma once

#include <string>

#include "scene/scene.h"

namespace ribbon {

// A scene of the required keys alone, nine lines long.
std::string smallest_scene();

// `text` with the first `from` replaced by `to`; `from` must occur.
std::string replaced(std::string text, const std::string& from, const std::string& to);

// Reads `text` as the file "<temporary folder>/knot.toml".
Result<Scene> read_text(const std::string& text);

// The error's sentence without the temporary folder, "" when `text` is a scene.
std::string complaint(const std::string& text);

}  // namespace ribbon

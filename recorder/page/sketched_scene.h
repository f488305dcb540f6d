// A scene with another drawing than it was written with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "result/result.h"

namespace ribbon {

// The file of a drawing that was made in a page, beside its scene.
inline constexpr std::string_view sketched_drawing = "sketch.svg";

// The text of a scene, in a file of this name, that draws the only path of sketched_drawing.
// letters: its list of crossings; empty: over and under alternate. Then the settings are changed,
// one after the other, as with_setting() does; all else stays as it was written. Fails where the
// scene is no TOML.
Result<std::string> sketched_scene(const std::string& file, const std::string& text,
                                   const std::string& letters,
                                   const std::vector<std::string>& settings);

}  // namespace ribbon

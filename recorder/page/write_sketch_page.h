// Drawing and tying in a browser.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "files/part_file.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// Writes the page in which one draws round the object of the scene, or round one of a few, and
// returns what there is to say of it. Fails where drawing or object of the scene cannot be read,
// where an older file is not to be replaced, and where the program was built without the page.
Result<std::string> write_sketch_page(const std::optional<Scene>& scene,
                                      const std::filesystem::path& page, Older older);

}  // namespace ribbon

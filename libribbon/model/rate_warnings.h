// What becomes of frame rates that are not whole, and of long motions.
#pragma once

#include <string>

#include "model/model.h"

namespace ribbon {

// One sentence each, without its full stop; empty: nothing goes wrong.

// Blender 3.4 places the keys of FBX and glTF at whole rates, whatever the scene's is.
std::string whole_rate_warning(const Model& model, int frames);

// Of formats that state the time of each frame in seconds, in single precision: told where a time
// is further off than a thousandth of a frame.
std::string rounded_time_warning(const Model& model, int frames);

// Both of them, as one text.
std::string joined_warnings(const std::string& one, const std::string& other);

}  // namespace ribbon

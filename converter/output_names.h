// The files that a conversion writes, by name.
#pragma once

#include <string>

namespace ribbon {

// The material library that all frames of `output` share, without its folder: what is left of the
// name without {frame} and the separators around it ("knot.{frame:04}.obj": "knot.mtl"; nothing
// left: "ribbon.mtl").
std::string material_library_name(const std::string& output);

}  // namespace ribbon

// The record structure of a binary FBX file, repaired where assimp leaves it open.
#pragma once

#include <string>
#include <string_view>

#include "result/result.h"

namespace ribbon {

// Copies a binary FBX file (version 7500 and later: 64-bit offsets) so that every nested list of
// records ends with its null record, as readers demand; offsets and the footer's padding follow.
//
// assimp before 5.3.0 leaves the null records of nested lists out and reports success; neither
// Blender nor assimp itself opens such a file. A file that is right is returned byte for byte, so
// with a newer assimp this changes nothing.
//
// Fails when the bytes are not such a file.
Result<std::string> repair_fbx_container(std::string_view bytes);

}  // namespace ribbon

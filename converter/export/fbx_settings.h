// What stands in an FBX file before its objects and behind them.
#pragma once

#include <vector>

#include "converter/export/fbx_record.h"
#include "model/model.h"

namespace ribbon {

// Who wrote it (at no time: the same frames give the same bytes), units, axes, frame rate, and how
// many objects of which type will follow.
std::vector<FbxRecord> fbx_settings(const Model& model, int frames);

// The list of what can be played.
FbxRecord fbx_takes(const Model& model, int frames);

}  // namespace ribbon

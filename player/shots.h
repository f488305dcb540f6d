// The cameras that the user asked for, and the files that their pictures go to.
#pragma once

#include <string>
#include <vector>

#include "player/options.h"
#include "player/view/camera_work.h"
#include "result/result.h"

namespace ribbon {

// One for each view asked for; without any, the three-quarter view. Fails when the keyframes cannot
// be read.
Result<std::vector<Shot>> shots_of(const Options& options);

// One for each shot: options.pictures with the view's name where {view} stands. Fails when several
// views would write the same files.
Result<std::vector<std::string>> output_names(const Options& options);

}  // namespace ribbon

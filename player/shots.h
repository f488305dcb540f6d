// The cameras that the user asked for, and the files that their pictures go to.
#pragma once

#include <string>
#include <vector>

#include "commandline/frame_pattern.h"
#include "player/options.h"
#include "player/view/camera_work.h"
#include "result/result.h"

namespace ribbon {

// One for each view asked for; without any, the three-quarter view. Fails when the keyframes cannot
// be read.
Result<std::vector<Shot>> shots_of(const Options& options);

// One for each shot: options.pictures with the view's name where {view} stands. For so many frames.
// Fails as FramePattern does, and when several views would write the same files.
Result<std::vector<FramePattern>> patterns_of(const Options& options, int frame_count);

}  // namespace ribbon

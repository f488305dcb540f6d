// Gathers the light of a picture.
#pragma once

#include "player/camera.h"
#include "player/lighting.h"
#include "player/picture.h"
#include "player/sampling.h"
#include "player/stage.h"

namespace ribbon {

// Every sample of a pixel sees one point and asks once whether the sun and once whether the sky
// reaches it. The pixels are the same for any number of threads.
LightPicture render(const Stage& stage, const Camera& camera, PictureSize size,
                    const SamplePatterns& patterns, const Lighting& lighting = {},
                    const Backdrop& backdrop = {});

}  // namespace ribbon

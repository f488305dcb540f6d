// Gathers the light of a picture.
#pragma once

#include "camera.h"
#include "lighting.h"
#include "picture.h"
#include "sampling.h"
#include "stage.h"

namespace ribbon {

// Every sample of a pixel sees one point and asks once whether the sun and once whether the sky
// reaches it. The pixels are the same for any number of threads.
LightPicture render(const Stage& stage, const Camera& camera, PictureSize size,
                    const SamplePatterns& patterns, const Lighting& lighting = {},
                    const Backdrop& backdrop = {});

}  // namespace ribbon

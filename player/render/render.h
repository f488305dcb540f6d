// Gathers the light of a picture.
#pragma once

#include "player/picture/picture.h"
#include "player/render/lighting.h"
#include "player/render/render_scene.h"
#include "player/render/sampling.h"
#include "player/view/camera.h"

namespace ribbon {

// Every sample of a pixel sees one point and asks once whether the sun and once whether the sky
// reaches it. The pixels are the same for any number of threads.
LightPicture render(const RenderScene& scene, const Camera& camera, PictureSize size,
                    const SamplePatterns& patterns, const Lighting& lighting = {},
                    const Backdrop& backdrop = {});

}  // namespace ribbon

#include "player/render/pixel_planes.h"

namespace ribbon {

PixelPlanes::PixelPlanes(PictureSize of_size) : size(of_size) {
  for (auto* planes : {&direct, &albedo, &sky, &normal, &position})
    for (Plane& plane : *planes) plane.resize(size.pixel_count());
  evenness.resize(size.pixel_count());
}

}  // namespace ribbon

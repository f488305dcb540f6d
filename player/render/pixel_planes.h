// What samples told about each pixel of a picture, before it becomes a picture.
#pragma once

#include <array>
#include <vector>

#include "player/picture/picture.h"

namespace ribbon {

// One number a pixel, row by row from the top left.
using Plane = std::vector<float>;
using Planes = std::array<Plane, 3>;

// A pixel shows direct + albedo x sky. The parts stand apart, because the light of the sky changes
// slowly along a surface and can be averaged over it; pattern, edges and shadows cannot.
struct PixelPlanes {
  explicit PixelPlanes(PictureSize of_size);

  PictureSize size;
  Planes direct;  // backdrop, and the sun's light as it is returned
  Planes albedo;
  Planes sky;       // light of the sky that arrives, of white cloth
  Planes normal;    // of the smooth surface, mean
  Planes position;  // mean, metres of the model
  // Samples behind `sky`; 0 where they saw the backdrop or more than one body, so that there is no
  // surface to speak of.
  Plane evenness;
};

}  // namespace ribbon

// Takes the noise out of the light of the sky.
#pragma once

#include "player/render/pixel_planes.h"

namespace ribbon {

// Replaces planes.sky by a mean over pixels that show the same smooth surface: neighbours count the
// less the more their normal leans and the further they lie off the tangent plane. Pixels without
// evenness keep theirs. `pixel_m`: what a pixel covers of a surface that faces the camera. (H.
// Dammertz and others, Edge-Avoiding À-Trous Wavelet Transform for fast Global Illumination
// Filtering, HPG 2010.) The same for any number of threads.
void smooth_sky(PixelPlanes& planes, float pixel_m);

}  // namespace ribbon

// Light as a picture shows it.
#pragma once

#include "player/picture/picture.h"

namespace ribbon {

struct Tone {
  float exposure_stops = 0;  // each doubles the light
  // Light near white and beyond comes ever closer to white instead of being cut off there; what is
  // darker than 0.7 stays as it is.
  bool soft = false;
};

// Replaces the light of each pixel, channel by channel.
void apply(const Tone& tone, LightPicture& light);

}  // namespace ribbon

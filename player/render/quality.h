// How much work goes into a picture.
#pragma once

#include <optional>
#include <string>

namespace ribbon {

// Which light reaches what is seen, besides the sun's.
enum class SkyLight {
  open,      // all of the sky, whatever hides it
  occluded,  // what is not hidden; what hides it returns a fixed part
  bounced    // what is not hidden, and what the hiding cloth itself receives from sun and sky
};

struct Quality {
  SkyLight sky = SkyLight::occluded;
  // Per pixel: all get the first number. In tiles whose estimated error exceeds `noise`, pixels
  // where that helps most get twice as many, again and again, until it does not, or until they have
  // the second. Where there is a `noise`, the first is even.
  int samples = 4;
  int most_samples = 64;
  float noise = 0;  // in 8-bit levels, of 255; 0: all pixels get `samples`
  // Light of the sky is averaged over neighbouring pixels of the same smooth surface.
  bool smooth_sky = false;
};

// Draft for speed, standard for dailies, final for a film. Nothing for other names.
std::optional<Quality> quality_named(const std::string& name);

}  // namespace ribbon

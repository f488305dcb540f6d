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
  // Per pixel: all get the first number. Some get twice as many, again and again, until they have
  // the second. Which, is told by one of the next two; where neither is set, none. Where one is,
  // the first number is even.
  int samples = 4;
  int most_samples = 64;
  // In 8-bit levels, of 255. In tiles whose estimated error exceeds it: the pixels where that helps
  // most.
  float noise = 0;
  // In squared 8-bit levels. Everywhere: the pixels from whose squared error each further sample
  // takes at least so much. Samples go where they do most for the picture as a whole.
  float least_gain = 0;
  // Light of the sky is averaged over neighbouring pixels of the same smooth surface.
  bool smooth_sky = false;

  // Whether some pixels may get more samples than others.
  [[nodiscard]] bool is_adaptive() const { return noise > 0 || least_gain > 0; }
  // How many all pixels get before anything is concluded from them.
  [[nodiscard]] int first_samples() const { return is_adaptive() ? samples / 2 : samples; }
};

// Draft for speed, standard for dailies, final for a film. Nothing for other names.
std::optional<Quality> quality_named(const std::string& name);

}  // namespace ribbon

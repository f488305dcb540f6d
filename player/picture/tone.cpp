#include "player/picture/tone.h"

#include <cmath>

#include "parallel/parallel.h"

namespace ribbon {

namespace {

constexpr float shoulder = 0.7F;  // where the soft curve leaves the straight line

float softened(float light) {
  if (light <= shoulder) return light;
  constexpr float room = 1 - shoulder;
  const float over = light - shoulder;
  return shoulder + over / (1 + over / room);
}

}  // namespace

void apply(const Tone& tone, LightPicture& light) {
  if (tone.exposure_stops == 0 && !tone.soft) return;
  const float factor = std::exp2(tone.exposure_stops);
  parallel_ranges(light.pixels.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (float& channel : light.pixels[i]) {
        channel *= factor;
        if (tone.soft) channel = softened(channel);
      }
  });
}

}  // namespace ribbon

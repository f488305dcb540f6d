#include "player/render/quality.h"

namespace ribbon {

// Measured (docs/play.md): standard comes within 49 dB, final within 57 dB of 1024 samples.
std::optional<Quality> quality_named(const std::string& name) {
  if (name == "draft") return Quality{SkyLight::open, 1, 1, 0, false};
  if (name == "standard") return Quality{SkyLight::occluded, 4, 32, 12, true};
  if (name == "final") return Quality{SkyLight::bounced, 16, 256, 2.7F, false};
  return std::nullopt;
}

}  // namespace ribbon

#include "player/render/quality.h"

namespace ribbon {

// Measured (docs/play.md): beside 1024 samples standard comes to about 50 dB, final to 57 dB and
// more.
std::optional<Quality> quality_named(const std::string& name) {
  if (name == "draft") return Quality{SkyLight::open, 1, 1, 0, false};
  if (name == "standard") return Quality{SkyLight::occluded, 4, 32, 3, true};
  if (name == "final") return Quality{SkyLight::bounced, 16, 256, 1.1F, false};
  return std::nullopt;
}

}  // namespace ribbon

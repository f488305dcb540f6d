#include "inspection/tightness_progress_text.h"

#include "text/number_text.h"

namespace ribbon {

std::string tightness_progress_text(float progress) {
  constexpr float most = 10;
  if (progress > most) return "progress over 1000 %";
  if (progress < -most) return "progress below -1000 %";
  return "progress " + decimals(100 * progress, 1) + " %";
}

}  // namespace ribbon

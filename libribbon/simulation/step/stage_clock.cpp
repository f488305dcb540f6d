#include "simulation/step/stage_clock.h"

namespace ribbon {

std::string_view word_for(Stage stage) {
  switch (stage) {
    case Stage::fastening:
      return "fastening";
    case Stage::displacement:
      return "displacement";
    case Stage::detection:
      return "detection";
    case Stage::repulsion:
      return "repulsion";
    case Stage::smoothing:
      return "smoothing";
    case Stage::errors:
      return "errors";
  }
  return "";
}

}  // namespace ribbon

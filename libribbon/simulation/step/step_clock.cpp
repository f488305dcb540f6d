#include "simulation/step/step_clock.h"

namespace ribbon {

std::string_view word_for(StepPhase phase) {
  switch (phase) {
    case StepPhase::fastening_force:
      return "fastening force";
    case StepPhase::integration:
      return "integration";
    case StepPhase::detection:
      return "detection";
    case StepPhase::repulsion:
      return "repulsion";
    case StepPhase::strain_correction:
      return "strain correction";
    case StepPhase::truncation:
      return "truncation";
    case StepPhase::recovery:
      return "recovery";
  }
  return "";
}

}  // namespace ribbon

#include "simulation/step/stage_clock.h"

namespace ribbon {

std::string_view word_for(StepStage stage) {
  switch (stage) {
    case StepStage::fastening_force:
      return "fastening force";
    case StepStage::integration:
      return "integration";
    case StepStage::detection:
      return "detection";
    case StepStage::repulsion:
      return "repulsion";
    case StepStage::strain_correction:
      return "strain correction";
    case StepStage::truncation:
      return "truncation";
    case StepStage::recovery:
      return "recovery";
  }
  return "";
}

}  // namespace ribbon

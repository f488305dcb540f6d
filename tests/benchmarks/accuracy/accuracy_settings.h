// The levels of accuracy and single settings around them.
#pragma once

#include <string>
#include <vector>

#include "scene/accuracy.h"

namespace ribbon {

struct AccuracySetting {
  std::string name;
  AccuracyLevel numbers;
  bool is_level = false;
};

// What all others are compared with: `reference` at a finer step.
AccuracySetting converged_setting(double step_s);

// The levels first, then each integrator at each step, then `balanced` with one number changed.
std::vector<AccuracySetting> compared_settings();

}  // namespace ribbon

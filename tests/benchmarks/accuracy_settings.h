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

// The finest step, which all others are compared with, first; second one twice as long: it shows
// how much is left to converge.
std::vector<AccuracySetting> converged_settings(double finest_step_s);

// The levels first, then each integrator at each step, then `balanced` with one number changed.
std::vector<AccuracySetting> compared_settings();

}  // namespace ribbon

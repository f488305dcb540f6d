// The accuracy ladder: what each level sets where the scene does not. docs/accuracy.md tells what
// each costs and how near it comes to the reference.
#pragma once

#include <array>
#include <string_view>

#include "scene/scene.h"

namespace ribbon {

struct AccuracyLevel {
  std::string_view word;  // for it in scene files
  double step_s = 0;
  IntegrationMethod integrator = IntegrationMethod::rk4;
  double tolerance = 0;
  StrainCorrectionScene strain_correction;
};

// From the fastest to the most accurate. A new Scene is `balanced`.
extern const std::array<AccuracyLevel, 4> accuracy_levels;

// Makes the scene one of that level: its step, usual integrator, tolerance and strain correction.
void set_accuracy(const AccuracyLevel& level, Scene& scene);

}  // namespace ribbon

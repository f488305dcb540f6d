#include "scene/accuracy.h"

namespace ribbon {

using enum IntegrationMethod;

const std::array<AccuracyLevel, 4> accuracy_levels = {{
    {"draft", 0.02, symplectic_euler, 0.15, {.strain = 0.08, .most_rounds = 20, .most_sweeps = 60}},
    {"balanced",
     0.01,
     symplectic_euler,
     0.1,
     {.strain = 0.08, .most_rounds = 20, .most_sweeps = 60}},
    {"fine", 0.005, rk4, 0.03, {.strain = 0.08, .most_rounds = 20, .most_sweeps = 60}},
    {"reference", 0.00125, rk4, 1e-3, {.strain = 0.08, .most_rounds = 20, .most_sweeps = 120}},
}};

void set_accuracy(const AccuracyLevel& level, Scene& scene) {
  scene.time.step_s = level.step_s;
  scene.time.usual_integrator = level.integrator;
  scene.time.tolerance = level.tolerance;
  scene.strain_correction = level.strain_correction;
}

}  // namespace ribbon

#include "benchmarks/accuracy/accuracy_settings.h"

#include <utility>

#include "text/number_text.h"

namespace ribbon {

namespace {

AccuracySetting stepped(const char* word, IntegrationMethod integrator, double step_s) {
  AccuracyLevel numbers = accuracy_levels[1];
  numbers.integrator = integrator;
  numbers.step_s = step_s;
  return {std::string(word) + ", " + short_number(step_s) + " s", numbers};
}

void add_steps(std::vector<AccuracySetting>& settings) {
  for (const double step_s : {0.04, 0.025, 0.02, 0.01, 0.005, 0.0025}) {
    settings.push_back(stepped("rk4", IntegrationMethod::rk4, step_s));
    settings.push_back(stepped("symplectic_euler", IntegrationMethod::symplectic_euler, step_s));
    settings.push_back(stepped("implicit", IntegrationMethod::implicit, step_s));
  }
}

void add_single_numbers(std::vector<AccuracySetting>& settings) {
  const AccuracyLevel& balanced = accuracy_levels[1];
  for (const double tolerance : {0.3, 0.15, 0.03, 0.01, 0.001}) {
    AccuracyLevel numbers = balanced;
    numbers.integrator = IntegrationMethod::implicit;
    numbers.tolerance = tolerance;
    settings.push_back({"implicit, tolerance " + short_number(tolerance), numbers});
  }
  for (const double strain : {0.06, 0.04}) {
    AccuracyLevel numbers = balanced;
    numbers.strain_correction.strain = strain;
    settings.push_back({"strain " + short_number(100 * strain) + " %", numbers});
  }
  for (const auto& [rounds, sweeps] : {std::pair{3, 5}, {10, 5}, {3, 20}, {20, 40}}) {
    AccuracyLevel numbers = balanced;
    numbers.strain_correction.most_rounds = rounds;
    numbers.strain_correction.most_sweeps = sweeps;
    settings.push_back(
        {std::to_string(rounds) + " rounds of " + std::to_string(sweeps) + " sweeps", numbers});
  }
}

}  // namespace

AccuracySetting converged_setting(double step_s) {
  AccuracySetting converged{"converged", accuracy_levels.back()};
  converged.numbers.step_s = step_s;
  return converged;
}

std::vector<AccuracySetting> compared_settings() {
  std::vector<AccuracySetting> settings;
  settings.reserve(accuracy_levels.size());
  for (const AccuracyLevel& level : accuracy_levels)
    settings.push_back({std::string(level.word), level, true});
  add_steps(settings);
  add_single_numbers(settings);
  return settings;
}

}  // namespace ribbon

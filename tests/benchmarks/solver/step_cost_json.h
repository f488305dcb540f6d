// What steps cost, as the benchmarks write it to files.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "benchmarks/solver/step_cost.h"

namespace ribbon {

inline nlohmann::ordered_json json_of(const StepCost& cost, int particles) {
  nlohmann::ordered_json phases;
  for (std::size_t phase = 0; phase < step_phase_count; ++phase)
    phases[std::string(word_for(static_cast<StepPhase>(phase)))] = cost.phase_s[phase];
  return {{"processor_s_per_step", cost.processor_s},
          {"wall_s_per_step", cost.wall_s},
          {"phase_s_per_step", phases},
          {"listed_pairs_per_step", cost.listed_pairs},
          {"sweeps_per_step", cost.sweeps},
          {"allocations_per_step", cost.allocations},
          {"start_bytes_per_particle", cost.start_bytes / particles},
          {"held_bytes_per_particle", cost.held_bytes / particles},
          {"most_bytes_per_particle", cost.most_bytes / particles}};
}

}  // namespace ribbon

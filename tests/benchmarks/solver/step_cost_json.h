// What steps cost, as the benchmarks write it to files.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "benchmarks/solver/step_cost.h"

namespace ribbon {

inline nlohmann::ordered_json json_of(const StepCost& cost, int particles) {
  nlohmann::ordered_json stages;
  for (std::size_t stage = 0; stage < step_stage_count; ++stage)
    stages[std::string(word_for(static_cast<StepStage>(stage)))] = cost.stage_s[stage];
  return {{"processor_s_per_step", cost.processor_s},
          {"wall_s_per_step", cost.wall_s},
          {"stage_s_per_step", stages},
          {"listed_pairs_per_step", cost.listed_pairs},
          {"sweeps_per_step", cost.sweeps},
          {"allocations_per_step", cost.allocations},
          {"start_bytes_per_particle", cost.start_bytes / particles},
          {"held_bytes_per_particle", cost.held_bytes / particles},
          {"most_bytes_per_particle", cost.most_bytes / particles}};
}

}  // namespace ribbon

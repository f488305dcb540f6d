// What becomes of a scene, told by its frames alone.
#pragma once

#include <string>

#include "benchmarks/solver/extreme_scenes.h"

namespace ribbon {

struct Outcome {
  std::string refusal;  // its sentence; empty where the scene was run
  int steps = 0;        // that were run; the last is the first with a coordinate that is no number
  bool is_finite = true;
  double worst_strain = 0;  // of any edge along or across, and diagonal where there is shear
  double last_strain = 0;
  // The most energy at any time, kinetic and elastic, over what there was at the start plus what
  // the fastening force has put in until then. Above 1, contact and strain correction have strained
  // springs.
  double energy = 0;
  // More than that by what all springs hold at the strain limit of 10 %: no bound is in sight.
  bool is_explosion = false;
  std::size_t intersecting_pairs = 0;  // exactly judged; of the frame with most of them
  double time_s = 0;                   // by a clock, of one step
};

// Runs at most `most_steps` of the scene's steps.
Outcome outcome_of(const ExtremeScene& extreme, int most_steps);

}  // namespace ribbon

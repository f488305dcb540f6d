// One fastening by one setting, and what of it can be compared with another.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "benchmarks/accuracy/accuracy_settings.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// The middles of the two ends, metres.
using Ends = Eigen::Matrix<double, 3, 2>;

struct AccuracyRun {
  double processor_s = 0;         // of all steps, on one thread
  double simulated_s = 0;         // that they were
  Eigen::Matrix3Xd start;         // 3 x particles, metres
  Eigen::Matrix3Xd last;          // likewise, at the end
  std::vector<Ends> ends;         // every fifth of a second
  std::optional<double> tight_s;  // none: not within the time
  double rope_length = 0;         // at the end
  double contact_share = 0;       // at the end
  double worst_strain = 0;        // of any step
  double energy = 0;              // EnergyAccount::most()
};

// Runs the scene, which has a fastening, for duration_s, a multiple of a fifth of a second as that
// is of the setting's step. Fails where the scene cannot be run.
Result<AccuracyRun> run_by(const AccuracySetting& setting, Scene scene, double duration_s);

}  // namespace ribbon

#include "simulation/step/gated_motion.h"

#include <numeric>
#include <utility>

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Layers that move together let each other pass one by one.
constexpr int most_truncations = 4;
constexpr int detections_of_stragglers = 3;  // before all particles count as such

}  // namespace

Gate::Gate(const RestSize& size, PairDistances pair_distances)
    : distances(std::move(pair_distances)),
      broad_phase({.reach_m = distances.largest_activation_m(),
                   .slack_m = 0.05 * size.shortest_edge_m(),
                   .longest_way_m = 4 * size.shortest_edge_m()},
                  distances),
      negligible_m(0.01 * size.shortest_edge_m()),
      farthest_m(1.5 * size.shortest_edge_m()) {}

void GatedMotion::detect(const Matrix3Xd& led, const Matrix3Xd& target, const Vector3d& fall_m) {
  const PhaseTimer timer(clock_, StepPhase::detection);
  gate_.broad_phase.detect(bodies_, free_positions(), led, target, fall_m);
  clock_.count_detection(candidates().pairs.size());
}

void GatedMotion::detect_around(std::span<const int> particles, Widening widening,
                                const Matrix3Xd& target) {
  const PhaseTimer timer(clock_, StepPhase::detection);
  gate_.broad_phase.widen(particles, widening, bodies_, target);
  clock_.count_detection(candidates().pairs.size());
}

void GatedMotion::detect_if_outgrown(const Matrix3Xd& target) {
  const PhaseTimer timer(clock_, StepPhase::detection);
  find_particles_outside(candidates(), target, gate_.outside);
  if (!gate_.outside.empty()) detect_around(gate_.outside, Widening::onward, target);
}

int GatedMotion::truncate(const Matrix3Xd& target) {
  const PhaseTimer timer(clock_, StepPhase::truncation);
  const auto advance = [&]() -> const TruncationReport& {
    return gate_.truncation.truncate(candidates(), bodies_, gate_.distances, target,
                                     gate_.free_positions);
  };
  for (int i = 0;; ++i) {
    const TruncationReport* report = &advance();
    // Stragglers get bounds that reach back to where they were, until there are none: at last all
    // particles do.
    for (int again = 1; !report->stragglers.empty(); ++again) {
      if (again > detections_of_stragglers) {
        gate_.outside.resize(free_positions().cols());
        std::iota(gate_.outside.begin(), gate_.outside.end(), 0);
      } else {
        gate_.outside = report->stragglers;
      }
      detect_around(gate_.outside, Widening::onward_and_back, target);
      report = &advance();
    }
    if (report->truncated == 0 || report->farthest_m < gate_.negligible_m ||
        i + 1 == most_truncations)
      return report->truncated;
  }
}

}  // namespace ribbon

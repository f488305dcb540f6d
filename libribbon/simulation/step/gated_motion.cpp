#include "simulation/step/gated_motion.h"

#include <numeric>

#include "simulation/truncation/displacement_truncation.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

// Layers that move together let each other pass one by one.
constexpr int most_truncations = 4;
constexpr int detections_of_stragglers = 3;  // before all particles count as such

}  // namespace

GateSettings::GateSettings(const RestSize& size, const PairDistances& pair_distances)
    : distances(pair_distances),
      broad_phase{.reach_m = distances.largest_activation_m(),
                  .slack_m = 0.05 * size.shortest_edge_m(),
                  .longest_displacement_m = 4 * size.shortest_edge_m()},
      negligible_m(0.01 * size.shortest_edge_m()),
      farthest_m(1.5 * size.shortest_edge_m()) {}

void GatedMotion::detect(const Matrix3Xd& target) {
  const StageTimer timer(clock_, StepStage::detection);
  candidates_ = find_contact_candidates(bodies_, settings_.broad_phase, free_positions_, target);
  clock_.count_detection(candidates_.pairs.size());
}

void GatedMotion::detect_around(const std::vector<int>& particles, Widening widening,
                                const Matrix3Xd& target) {
  const StageTimer timer(clock_, StepStage::detection);
  widen(particles, widening, bodies_, settings_.broad_phase, target, candidates_);
  clock_.count_detection(candidates_.pairs.size());
}

void GatedMotion::detect_if_outgrown(const Matrix3Xd& target) {
  const StageTimer timer(clock_, StepStage::detection);
  const std::vector<int> outside = particles_outside(candidates_, target);
  if (!outside.empty()) detect_around(outside, Widening::onward, target);
}

int GatedMotion::truncate(const Matrix3Xd& target) {
  const StageTimer timer(clock_, StepStage::truncation);
  const auto advance = [&] {
    return truncate_displacements(candidates_, bodies_, settings_.distances, target,
                                  free_positions_);
  };
  TruncationReport report;
  for (int i = 0; i < most_truncations; ++i) {
    report = advance();
    // Stragglers get bounds that reach back to where they were, until there are none: at last all
    // particles do.
    for (int again = 1; !report.stragglers.empty(); ++again) {
      if (again > detections_of_stragglers) {
        report.stragglers.resize(free_positions_.cols());
        std::iota(report.stragglers.begin(), report.stragglers.end(), 0);
      }
      detect_around(report.stragglers, Widening::onward_and_back, target);
      report = advance();
    }
    if (report.truncated == 0 || report.farthest_m < settings_.negligible_m) break;
  }
  return report.truncated;
}

}  // namespace ribbon

// How the positions of one step reach the cloth through the gate.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "ribbon_mesh/rest_size.h"
#include "simulation/contact/pair_distances.h"
#include "simulation/detection/bodies.h"
#include "simulation/detection/feature_pairs.h"
#include "simulation/step/stage_clock.h"
#include "simulation/truncation/contact_candidates.h"

namespace ribbon {

struct GateSettings {
  GateSettings(const RestSize& size, const PairDistances& pair_distances);

  PairDistances distances;
  BroadPhaseLengths broad_phase;
  double negligible_m;  // displacements that are not worth another truncation
  double farthest_m;    // that particles should go between two gates
};

// Within one step, or some of its substeps: from the positions at its start, in which nothing
// intersects, stage by stage toward the targets that integration and corrections set. What it
// refers to must outlive it.
class GatedMotion {
 public:
  GatedMotion(const GateSettings& settings, Eigen::Matrix3Xd start, double duration_s,
              Bodies& bodies, StageClock& clock)
      : settings_(settings),
        bodies_(bodies),
        clock_(clock),
        free_positions_(std::move(start)),
        duration_s_(duration_s) {}

  // The broad phase, around the displacements from the free positions to the targets.
  void detect(const Eigen::Matrix3Xd& target);

  // Detects again around the particles whose targets lie outside their bounds, which would
  // truncate them.
  void detect_if_outgrown(const Eigen::Matrix3Xd& target);

  // Moves the free positions toward the targets as far as displacement truncation lets. Returns how
  // many particles do not reach them.
  int truncate(const Eigen::Matrix3Xd& target);

  // In which nothing intersects: as far as the gate has let the ribbon pass.
  [[nodiscard]] const Eigen::Matrix3Xd& free_positions() const { return free_positions_; }
  [[nodiscard]] const ContactCandidates& candidates() const { return candidates_; }
  [[nodiscard]] double duration_s() const { return duration_s_; }
  // Pairs this close may come into contact by what still moves them.
  [[nodiscard]] double reach_m() const {
    return settings_.broad_phase.reach_m + settings_.broad_phase.slack_m;
  }

 private:
  void detect_around(const std::vector<int>& particles, Widening widening,
                     const Eigen::Matrix3Xd& target);

  const GateSettings& settings_;
  Bodies& bodies_;
  StageClock& clock_;
  Eigen::Matrix3Xd free_positions_;
  double duration_s_;
  ContactCandidates candidates_;
};

}  // namespace ribbon

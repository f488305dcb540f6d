// How the positions of one step reach the cloth through the gate.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/rest_size.h"
#include "simulation/contact/pair_distances.h"
#include "simulation/detection/bodies.h"
#include "simulation/step/step_clock.h"
#include "simulation/truncation/contact_candidates.h"
#include "simulation/truncation/displacement_truncation.h"

namespace ribbon {

// The gate's settings, and its phases, which keep their memory from motion to motion.
struct Gate {
  Gate(const RestSize& size, PairDistances pair_distances);

  PairDistances distances;
  BroadPhase broad_phase;
  DisplacementTruncation truncation;
  Eigen::Matrix3Xd free_positions;  // of the present motion
  std::vector<int> outside;         // particles whose targets lie outside their bounds
  double negligible_m;              // displacements that are not worth another truncation
  double farthest_m;                // that particles should go between two gates
};

// Within one step, or some of its substeps: from the positions at its start, in which nothing
// intersects, phase by phase toward the targets that integration and corrections set. What it
// refers to must outlive it, and the gate serves one motion at a time.
class GatedMotion {
 public:
  GatedMotion(Gate& gate, const Eigen::Matrix3Xd& start, double duration_s, Bodies& bodies,
              StepClock& clock)
      : gate_(gate), bodies_(bodies), clock_(clock), duration_s_(duration_s) {
    gate_.free_positions = start;
  }

  // The broad phase, around the displacements from the free positions to the targets; `led` is
  // where motion alone leads, and all may fall so far as well.
  void detect(const Eigen::Matrix3Xd& led, const Eigen::Matrix3Xd& target,
              const Eigen::Vector3d& fall_m = Eigen::Vector3d::Zero());

  // Detects again around the particles whose targets lie outside their bounds, which would
  // truncate them.
  void detect_if_outgrown(const Eigen::Matrix3Xd& target);

  // Moves the free positions toward the targets as far as displacement truncation lets. Returns how
  // many particles do not reach them.
  int truncate(const Eigen::Matrix3Xd& target);

  // In which nothing intersects: as far as the gate has let the ribbon pass.
  [[nodiscard]] const Eigen::Matrix3Xd& free_positions() const { return gate_.free_positions; }
  [[nodiscard]] const ContactCandidates& candidates() const {
    return gate_.broad_phase.candidates();
  }
  [[nodiscard]] double duration_s() const { return duration_s_; }
  // So far from contact, pairs may come into it by what still moves them.
  [[nodiscard]] double slack_m() const { return gate_.broad_phase.lengths().slack_m; }

 private:
  void detect_around(std::span<const int> particles, Widening widening,
                     const Eigen::Matrix3Xd& target);

  Gate& gate_;
  Bodies& bodies_;
  StepClock& clock_;
  double duration_s_;
};

}  // namespace ribbon

// Contact as the strain correction knows it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "simulation/contact/pair_distances.h"
#include "simulation/state/cloth.h"
#include "simulation/truncation/contact_candidates.h"
#include "simulation/truncation/sweep_activity.h"

namespace ribbon {

// Over the four vertices of a pair, normal . sum(weights[k] * x_k) shall be at least distance_m.
struct ContactConstraint {
  std::array<int, 4> vertices{};
  Eigen::Vector4d weights = Eigen::Vector4d::Zero();
  // By how much each vertex moves to make up for a violation of 1 m; 0 for the obstacle's.
  Eigen::Vector4d corrections = Eigen::Vector4d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double distance_m = 0;
};

// And their sweeps. Keeps its memory.
class ContactConstraints {
 public:
  // As Cloth has it.
  explicit ContactConstraints(Eigen::ArrayXd lightness = {}) : lightness_(std::move(lightness)) {}

  // One for each listed pair that could come into contact, or so near to it, between
  // `free_positions`, in which nothing intersects, and `target` (3 x particles each), and whose
  // closest points tell how the surfaces lie there (locally_closest.h): contact shall not
  // begin, or, where it has begun, open by a fifth of what lacks. That is along the line between
  // those points in the free ones or, where the way to the targets leads to contact, in the pair's
  // approach (approach.h) down to the minimum separation. All may fall so far as well: pairs that
  // this alone would bring together count, too, but it turns no line.
  void find(const ContactCandidates& candidates, const Bodies& bodies,
            const PairDistances& distances, double beyond_m, const Eigen::Matrix3Xd& free_positions,
            const Eigen::Matrix3Xd& target,
            const Eigen::Vector3d& fall_m = Eigen::Vector3d::Zero());
  [[nodiscard]] const std::vector<ContactConstraint>& found() const { return found_; }

  // From the next find() on contact opens by that fraction (0 to 1) of how far it otherwise would.
  void ease(double fraction) { opened_fraction_ = fraction; }

  // None of the constraints has been looked at, and activity has been reset.
  void begin_sweeps();

  // One sweep: moves apart, in order and by momentum conservation, the pairs that do not keep their
  // distance, and takes from them the speed at which they approach, so that kinetic energy never
  // grows. What moves is told to `activity`, and pairs that kept their distance by more than their
  // vertices have moved since are passed over. With `friction` (Coulomb's coefficient, >= 0;
  // friction.h) what the contact points have slid over each other since `before` (3 x particles)
  // and the speed at which they slide are reduced likewise. Was any distance violated by more than
  // 3 % of it?
  bool keep_apart(double friction, const Eigen::Matrix3Xd& before, const Bodies& bodies,
                  SweepActivity& activity, Cloth& cloth);

 private:
  // All that a sweep reads of most constraints.
  struct Watch {
    std::array<int, 4> vertices{};  // as SweepActivity numbers them
    double kept_until_m = 0;        // until these have travelled so far together
  };

  Eigen::ArrayXd lightness_;
  double opened_fraction_ = 1;
  Eigen::Matrix3Xd displacement_;
  Eigen::Matrix3Xd falling_;  // likewise, with the fall
  ApproachingPairs approaching_;
  std::vector<std::size_t> order_;  // of the listed pairs
  std::vector<ContactConstraint> found_;
  std::vector<Watch> watches_;  // of these
};

}  // namespace ribbon

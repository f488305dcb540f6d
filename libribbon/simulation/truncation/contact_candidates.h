// The broad phase: what the ribbon could touch until the next detection.
#pragma once

#include <Eigen/Core>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "simulation/contact/pair_distances.h"
#include "simulation/detection/bodies.h"
#include "simulation/detection/feature_pairs.h"

namespace ribbon {

// Every particle has a motion bound that it does not leave until the next detection, and every pair
// of features that could come within reach of each other inside those bounds is listed. One
// detection thus serves all that moves the particles within a step: what is not listed cannot meet.
//
// Bounds move with the cloth: the particles start together, each at its place, go the same part of
// their displacements at every instant, and then stay in the boxes at the end. So neighbours that
// travel far together are not listed. The bound of a straggler, which something stops on the way,
// reaches back to its place.
struct ContactCandidates {
  Eigen::Matrix3Xd from;                 // where the particles were at the detection
  std::vector<MovingBox> bounds;         // one for each particle
  std::vector<FeaturePair> pairs;        // ribbon-ribbon and ribbon-obstacle, each once
  std::vector<double> distances_m;       // of the pairs, at the detection
  std::vector<Eigen::Vector4d> weights;  // likewise, as closest_weights() gives them
};

struct BroadPhaseLengths {
  double reach_m = 0;  // pairs that could come this close are listed
  double slack_m = 0;  // room beyond the target, for what moves the particle later
  // Bounds reach no further, unless motion leads there: a wild target would list the whole ribbon.
  double longest_way_m = 0;
};

enum class Widening { onward, onward_and_back };

// Keeps its memory from one detection to the next.
class BroadPhase {
 public:
  // With `distances`, pairs are listed that could come within their own activation distances, none
  // of which is above lengths.reach_m.
  explicit BroadPhase(const BroadPhaseLengths& lengths,
                      std::optional<PairDistances> distances = std::nullopt)
      : lengths_(lengths), distances_(std::move(distances)) {
    assert(!distances_ || distances_->largest_activation_m() <= lengths_.reach_m);
  }

  // Detects around the straight way from `from` to `target`, or to where the longest way toward it
  // ends; `led` is where motion alone leads (3 x particles each). All may fall so far as well.
  const ContactCandidates& detect(Bodies& bodies, const Eigen::Matrix3Xd& from,
                                  const Eigen::Matrix3Xd& led, const Eigen::Matrix3Xd& target,
                                  const Eigen::Vector3d& fall_m = Eigen::Vector3d::Zero());

  // Widens the bounds of some particles, wherever they are in theirs, to reach on toward their
  // present targets, as in detect(), and, for stragglers, back to where they were at the detection.
  // Pairs with these particles are listed anew; the others stay.
  void widen(std::span<const int> particles, Widening widening, Bodies& bodies,
             const Eigen::Matrix3Xd& target);

  [[nodiscard]] const BroadPhaseLengths& lengths() const { return lengths_; }
  // What the last detection found.
  [[nodiscard]] const ContactCandidates& candidates() const { return candidates_; }

 private:
  // How a particle moves inside its bound: by a displacement, and beside it as far as its freedom
  // goes.
  struct Motion {
    Eigen::Vector3d displacement;  // to the middle of the bound
    double freedom_m = 0;
  };

  [[nodiscard]] Box around_target(int particle, const Eigen::Vector3d& target) const;
  void set_motion(int particle);
  void drop_pairs_of(std::span<const int> particles);
  void add_near_pairs(const Bodies& bodies);
  [[nodiscard]] bool could_meet(const FeaturePair& pair, double distance_m,
                                double approach_m) const;

  BroadPhaseLengths lengths_;
  std::optional<PairDistances> distances_;
  ContactCandidates candidates_;
  Eigen::Matrix3Xd led_;                                  // of the last detection
  Eigen::Vector3d fall_ = Eigen::Vector3d::Zero();        // likewise, m,
  double fall_m_ = 0;                                     // and its length
  Eigen::Vector3d common_way_ = Eigen::Vector3d::Zero();  // of all to their targets, on average, m
  std::vector<Motion> motions_;                           // of the particles
  std::vector<FeaturePair> found_;                        // whose boxes meet
  std::vector<double> distances_m_;                       // of these pairs
  std::vector<Eigen::Vector4d> weights_;                  // likewise
  std::vector<char> is_near_;                             // are they?
  std::vector<char> is_named_;                            // are the particles?
};

// Pairs of which no vertex is to be displaced.
enum class RestingPairs { found, left_out };

// Tells pairs whose vertices move together from those that approach. Keeps its memory.
class ApproachingPairs {
 public:
  // Indices, in order, of the listed pairs that may come within reach of each other while all
  // particles move from `positions` along equal parts of their `displacement` (3 x particles each).
  // Those that rest within reach are found only where they are asked for.
  const std::vector<std::size_t>& find(const ContactCandidates& candidates,
                                       const Eigen::Matrix3Xd& positions,
                                       const Eigen::Matrix3Xd& displacement, const PairReach& reach,
                                       RestingPairs resting);

  // Likewise, of the listed pairs with these indices alone, after find() with the same candidates,
  // positions and reach, and where no particle goes farther than it would have gone there.
  const std::vector<std::size_t>& find_among(std::span<const std::size_t> pairs,
                                             const ContactCandidates& candidates,
                                             const Eigen::Matrix3Xd& displacement);

  // After find() with these candidates: closest_weights() of the listed pair with this index, whose
  // corners lie so at the positions given there. Computed only if any particle has left the place
  // where the detection measured it.
  [[nodiscard]] Eigen::Vector4d weights(std::size_t pair, const ContactCandidates& candidates,
                                        const Eigen::Matrix<double, 3, 4>& corners) const;

 private:
  void measure(const ContactCandidates& candidates, const Eigen::Matrix3Xd& positions,
               const Eigen::Matrix3Xd& displacement);

  bool has_gone_ = false;         // has any particle, since the detection?
  Eigen::Matrix3Xd gone_;         // by each particle
  std::vector<double> moved_m_;   // that, and what it is to be displaced by
  std::vector<char> is_resting_;  // is it to be displaced by nothing?
  // Of the pairs: by so much, or more, their displacements may differ; infinite where none that is
  // as short as in find() can differ by too much.
  std::vector<double> rooms_m_;
  std::vector<char> is_approaching_;  // of the pairs
  std::vector<std::size_t> found_;
};

// Makes `outside` the particles whose targets lie outside their bounds, in order.
void find_particles_outside(const ContactCandidates& candidates, const Eigen::Matrix3Xd& target,
                            std::vector<int>& outside);

}  // namespace ribbon

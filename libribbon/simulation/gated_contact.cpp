#include <algorithm>

#include "simulation/collision_response.h"
#include "simulation/contact.h"
#include "simulation/gate.h"
#include "simulation/surroundings.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr int repulsion_rounds = 3;
// Layers that move together let each other pass one by one.
constexpr int passages = 4;

class GatedContact : public Contact {
 public:
  GatedContact(Bodies& bodies, const ContactProperties& properties, double step_s)
      : bodies_(bodies),
        gaps_(properties.size, gap_lengths(properties.size.shortest_edge_m(), properties.rounding_m,
                                           properties.thickness_m)),
        repulsion_settings_{.friction = properties.friction},
        survey_lengths_{.reach_m = gaps_.largest_contact_m(),
                        .slack_m = 0.15 * properties.size.shortest_edge_m(),
                        .longest_way_m = 4 * properties.size.shortest_edge_m()},
        negligible_m_(0.01 * properties.size.shortest_edge_m()),
        step_s_(step_s) {}

  void after_displacement(const Matrix3Xd& before, Cloth& cloth) override {
    certified_ = before;
    surroundings_ = survey(bodies_, survey_lengths_, certified_, cloth.positions);
    pass(cloth);
  }

  int after_smoothing(Cloth& cloth) override {
    // A few vertices that wish to leave their ranges are held back; many are worth a new survey.
    if (count_outside(surroundings_, cloth.positions) > cloth.particle_count() / 100)
      surroundings_ = survey(bodies_, survey_lengths_, certified_, cloth.positions);
    pass(cloth);
    return 0;
  }

 private:
  // From the certified positions toward the cloth's wish, repelled first and then as far as the
  // gate lets.
  void pass(Cloth& cloth) {
    repel(cloth);
    for (int i = 0; i < passages; ++i) {
      const Passage passage = pass_gate(surroundings_, gaps_, cloth.positions, certified_);
      if (passage.held_back == 0 || passage.farthest_m < negligible_m_) break;
    }
    stop_what_is_held_back(cloth);
    cloth.positions = certified_;
  }

  // What the gate held back is taken from the velocity, as far as there is any in that direction: a
  // repulsion or smoothing that did not get through must not throw a particle the other way.
  void stop_what_is_held_back(Cloth& cloth) const {
    for (Eigen::Index particle = 0; particle < cloth.particle_count(); ++particle) {
      const Eigen::Vector3d held = cloth.positions.col(particle) - certified_.col(particle);
      const double held_m = held.norm();
      const double speed_m_s = held_m > 0 ? held.dot(cloth.velocities.col(particle)) / held_m : 0;
      if (speed_m_s > 0)
        cloth.velocities.col(particle) -= std::min(speed_m_s, held_m / step_s_) * held / held_m;
    }
  }

  void repel(Cloth& cloth) {
    std::vector<FeaturePair> pairs;
    for (const std::size_t i :
         approaching_pairs(surroundings_, certified_, cloth.positions - certified_,
                           survey_lengths_.reach_m + survey_lengths_.slack_m))
      pairs.push_back(surroundings_.pairs[i]);
    for (int round = 0; round < repulsion_rounds; ++round)
      if (!repel_once(pairs, gaps_, repulsion_settings_, certified_, cloth)) return;
  }

  Bodies& bodies_;
  PairGaps gaps_;
  RepulsionSettings repulsion_settings_;
  SurveyLengths survey_lengths_;
  double negligible_m_;
  double step_s_;
  Matrix3Xd certified_;  // positions that the gate has let pass
  Surroundings surroundings_;
};

}  // namespace

std::unique_ptr<Contact> gated_contact(Bodies& bodies, const ContactProperties& properties,
                                       double step_s) {
  return std::make_unique<GatedContact>(bodies, properties, step_s);
}

}  // namespace ribbon

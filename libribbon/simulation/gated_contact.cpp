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
  GatedContact(Bodies& bodies, const ContactLengths& lengths, double step_s)
      : bodies_(bodies),
        gaps_(bodies.grid, lengths.edge_m, lengths.edge_m,
              gap_lengths(lengths.edge_m, lengths.rounding_m, lengths.thickness_m)),
        survey_lengths_{.reach_m = gaps_.largest_contact_m(),
                        .slack_m = 0.15 * lengths.edge_m,
                        .longest_way_m = 4 * lengths.edge_m},
        negligible_m_(0.01 * lengths.edge_m),
        step_s_(step_s) {}

  void after_displacement(const Matrix3Xd& before, Cloth& cloth) override {
    certified_ = before;
    surroundings_ = survey(bodies_, survey_lengths_, certified_, cloth.positions);
    pass(cloth);
  }

  int after_smoothing(Cloth& cloth) override {
    // A few vertices that wish to leave their ranges are held back; many are worth a new survey.
    if (100 * count_outside(surroundings_, cloth.positions) > cloth.particle_count())
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
    cloth.velocities += (certified_ - cloth.positions).leftCols(cloth.particle_count()) / step_s_;
    cloth.positions = certified_;
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

std::unique_ptr<Contact> gated_contact(Bodies& bodies, const ContactLengths& lengths,
                                       double step_s) {
  return std::make_unique<GatedContact>(bodies, lengths, step_s);
}

}  // namespace ribbon

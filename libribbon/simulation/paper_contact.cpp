#include "simulation/collision_response.h"
#include "simulation/contact.h"
#include "simulation/recovery.h"
#include "simulation/swept_pairs.h"

namespace ribbon {

namespace {

constexpr int repulsion_rounds = 10;  // of detection and repulsion, at most

class PaperContact : public Contact {
 public:
  PaperContact(Bodies& bodies, const ContactProperties& properties)
      : bodies_(bodies),
        gaps_(properties.size, {.contact_m = 0.1 * properties.size.shortest_edge_m(),
                                .thickness_m = properties.thickness_m}),
        repulsion_settings_{.friction = properties.friction},
        recovery_settings_{.gap_m = 0.1 * properties.size.shortest_edge_m(),
                           .step_m = 0.5 * properties.size.shortest_edge_m()} {}

  void after_displacement(const Eigen::Matrix3Xd& before, Cloth& cloth) override {
    for (int round = 0; round < repulsion_rounds; ++round)
      if (!repel_once(
              swept_pairs_by_curvature(bodies_, before, cloth.positions, gaps_.largest_contact_m()),
              gaps_, repulsion_settings_, before, cloth))
        return;
  }

  int after_smoothing(Cloth& cloth) override {
    return recover(bodies_, recovery_settings_, cloth.positions).iterations;
  }

 private:
  Bodies& bodies_;
  PairGaps gaps_;
  RepulsionSettings repulsion_settings_;
  RecoverySettings recovery_settings_;
};

}  // namespace

std::unique_ptr<Contact> paper_contact(Bodies& bodies, const ContactProperties& properties) {
  return std::make_unique<PaperContact>(bodies, properties);
}

}  // namespace ribbon

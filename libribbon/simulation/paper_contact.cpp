#include "simulation/collision_response.h"
#include "simulation/contact.h"
#include "simulation/recovery.h"

namespace ribbon {

namespace {

class PaperContact : public Contact {
 public:
  PaperContact(Bodies& bodies, const ContactLengths& lengths)
      : bodies_(bodies),
        collision_settings_{.gap_m = 0.1 * lengths.edge_m},
        recovery_settings_{.gap_m = 0.1 * lengths.edge_m, .step_m = 0.5 * lengths.edge_m} {}

  void after_displacement(const Eigen::Matrix3Xd& before, Cloth& cloth) override {
    repel_collisions(bodies_, collision_settings_, Hierarchy::Spare::curvature_and_boxes, before,
                     cloth);
  }

  int after_smoothing(Cloth& cloth) override {
    return recover(bodies_, recovery_settings_, cloth.positions).iterations;
  }

 private:
  Bodies& bodies_;
  ContactSettings collision_settings_;
  RecoverySettings recovery_settings_;
};

}  // namespace

std::unique_ptr<Contact> paper_contact(Bodies& bodies, const ContactLengths& lengths) {
  return std::make_unique<PaperContact>(bodies, lengths);
}

}  // namespace ribbon

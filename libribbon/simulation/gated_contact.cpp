#include <algorithm>

#include "simulation/collision_response.h"
#include "simulation/contact.h"
#include "simulation/gate.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

class GatedContact : public Contact {
 public:
  GatedContact(Bodies& bodies, const ContactLengths& lengths, double step_s)
      : bodies_(bodies),
        // Rounding moves each of two points by at most sqrt 3 roundings; twice that leaves room.
        // Neighbours in the flat ribbon must not count as too close, however coarse the rounding.
        min_gap_m_(std::clamp(4 * 1.7321 * lengths.rounding_m, 0.05 * lengths.edge_m,
                              0.2 * lengths.edge_m)),
        collision_settings_{.gap_m = std::max(0.2 * lengths.edge_m, 2 * min_gap_m_), .rounds = 3},
        step_s_(step_s) {}

  void after_displacement(const Matrix3Xd& before, Cloth& cloth) override { pass(before, cloth); }

  int after_smoothing(Cloth& cloth) override {
    const Matrix3Xd certified = certified_;
    pass(certified, cloth);
    return 0;
  }

 private:
  // From `certified` toward the cloth's wish, repelled first and then as far as the gate lets.
  void pass(const Matrix3Xd& certified, Cloth& cloth) {
    repel_collisions(bodies_, collision_settings_, Hierarchy::Spare::boxes, certified, cloth);
    const Matrix3Xd wished = cloth.positions;
    cloth.positions = certified;
    pass_gate(bodies_, min_gap_m_, wished, cloth.positions);
    cloth.velocities += (cloth.positions - wished).leftCols(cloth.particle_count()) / step_s_;
    certified_ = cloth.positions;
  }

  Bodies& bodies_;
  double min_gap_m_;
  ContactSettings collision_settings_;
  double step_s_;
  Matrix3Xd certified_;
};

}  // namespace

std::unique_ptr<Contact> gated_contact(Bodies& bodies, const ContactLengths& lengths,
                                       double step_s) {
  return std::make_unique<GatedContact>(bodies, lengths, step_s);
}

}  // namespace ribbon

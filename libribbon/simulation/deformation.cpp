#include "simulation/deformation.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double strain_limit = 0.1;   // of the natural length (section 5.5)
constexpr int correction_rounds = 10;  // at most, in one step (section 5.5)

std::unique_ptr<Contact> contact_of(const Scene& scene, const NaturalSize& size, Bodies& bodies) {
  const ContactProperties properties{size, scene.recording.max_position_error_m(size.length_m),
                                     scene.ribbon.thickness_m, scene.friction};
  return scene.contact == ContactMethod::paper
             ? paper_contact(bodies, properties)
             : gated_contact(bodies, properties, scene.time.step_s);
}

}  // namespace

Deformation::Deformation(const Scene& scene, const NaturalSize& size, double particle_mass_kg,
                         Bodies& bodies)
    : step_s_(scene.time.step_s),
      springs_(spring_network(size.grid, size.length_m, size.width_m, scene.springs)),
      integrator_(runge_kutta(springs_, {scene.time.step_s, size.grid.particle_count(),
                                         particle_mass_kg, scene.air_resistance_per_s})),
      strain_correction_(size.grid, size.length_m, size.width_m, strain_limit),
      contact_(contact_of(scene, size, bodies)) {}

int Deformation::step(const Matrix3Xd& fastening_force, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  integrator_->displace(fastening_force, cloth);
  contact_->after_displacement(before, cloth);
  correct_strain(cloth);
  return contact_->after_smoothing(cloth);
}

void Deformation::move(const Matrix3Xd& wished, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  cloth.positions = wished;
  contact_->after_displacement(before, cloth);
  cloth.velocities.setZero();
}

int Deformation::settle(int rounds, Cloth& cloth) {
  int recovery_iterations = 0;
  for (int round = 0; round < rounds; ++round) {
    correct_strain(cloth);
    recovery_iterations += contact_->after_smoothing(cloth);
    if (!strain_correction_.any_over_limit(cloth.positions)) break;
  }
  cloth.velocities.setZero();
  return recovery_iterations;
}

// while ∃ over-stretched edge: apply post-step correction. What moves the particles also changes
// their velocities, so that the springs are not stretched again in the next step.
void Deformation::correct_strain(Cloth& cloth) const {
  const Matrix3Xd before = cloth.positions;
  int rounds = 0;
  while (rounds < correction_rounds && strain_correction_.any_over_limit(cloth.positions)) {
    strain_correction_.apply(cloth.positions);
    ++rounds;
  }
  if (rounds > 0)
    cloth.velocities += (cloth.positions - before).leftCols(cloth.particle_count()) / step_s_;
}

}  // namespace ribbon

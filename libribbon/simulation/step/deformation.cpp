#include "simulation/step/deformation.h"

#include "ribbon_mesh/springs.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

std::unique_ptr<PostStep> post_step_of(const Scene& scene, const RestSize& size, Bodies& bodies,
                                       StageClock& clock) {
  const PostStepProperties properties{
      .size = size,
      .step_s = scene.time.step_s,
      .resists_shear = scene.springs.shear > 0,
      .rounding_m = scene.recording.max_position_error_m(size.length_m),
      .smoothing = scene.smoothing,
      .thickness_m = scene.ribbon.thickness_m,
      .friction = scene.friction};
  return scene.contact == ContactMethod::paper ? published_post_step(bodies, properties, clock)
                                               : gated_post_step(bodies, properties, clock);
}

}  // namespace

Deformation::Deformation(const Scene& scene, const RestSize& size, double particle_mass_kg,
                         Bodies& bodies)
    : integrator_(create_integrator(
          scene.time.integrator, spring_network(size, scene.springs),
          {scene.time.step_s, particle_mass_kg, scene.air_resistance_per_s, scene.time.tolerance})),
      post_step_(post_step_of(scene, size, bodies, *clock_)) {}

PostStepReport Deformation::step(const Matrix3Xd& fastening_force, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  clock_->charge(Stage::displacement);
  integrator_->displace(fastening_force, cloth);
  const PostStepReport report = post_step_->correct(before, cloth);
  clock_->stop();
  return report;
}

void Deformation::move(const Matrix3Xd& wished, Cloth& cloth) {
  const Matrix3Xd before = cloth.positions;
  cloth.positions = wished;
  post_step_->correct(before, cloth);
  cloth.velocities.setZero();
}

PostStepReport Deformation::settle(int rounds, Cloth& cloth) {
  PostStepReport last{.is_over_limit = true};
  for (int round = 0; round < rounds && last.is_over_limit; ++round) {
    const Matrix3Xd before = cloth.positions;
    const int recovery_iterations = last.recovery_iterations;
    last = post_step_->correct(before, cloth);
    last.recovery_iterations += recovery_iterations;
  }
  cloth.velocities.setZero();
  return last;
}

}  // namespace ribbon

#include "benchmarks/solver/energy_account.h"

#include <algorithm>
#include <cmath>

#include "simulation/integration/spring_networks.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

constexpr double strain_limit = 0.1;  // paper, section 5.5

}  // namespace

EnergyAccount::EnergyAccount(const Scene& scene, const RibbonMesh& mesh, const Matrix3Xd& start)
    : network_(spring_network(mesh.size(), scene.springs)),
      step_s_(scene.time.step_s),
      mass_kg_(scene.ribbon.mass_kg / mesh.grid.particle_count()),
      put_in_j_(elastic_energy_j(network_, start)),
      gravity_m_s2_(scene.gravity_m_s2.value_or(Eigen::Vector3d::Zero())) {
  if (scene.fastening)
    force_.emplace(*scene.fastening, scene.air_resistance_per_s, mesh.size(), start, mass_kg_);
}

void EnergyAccount::add_step(const Matrix3Xd& before, const Matrix3Xd& after) {
  const Matrix3Xd way = after - before;
  if (force_)
    put_in_j_ += std::max(0.0, force_->at(before).leftCols(way.cols()).cwiseProduct(way).sum());
  put_in_j_ += std::max(0.0, mass_kg_ * gravity_m_s2_.dot(way.rowwise().sum()));
  const double kinetic_j = mass_kg_ / 2 * (way / step_s_).squaredNorm();
  const double energy_j = elastic_energy_j(network_, after) + kinetic_j;
  if (energy_j > 0) most_ = std::max(most_, energy_j / put_in_j_);
  is_explosion_ = is_explosion_ || energy_j > put_in_j_ + at_strain_limit_j();
}

double EnergyAccount::at_strain_limit_j() const {
  double sum_j = 0;
  for_each_spring(network_, [&](int, int, double rest_length_m, double stiffness) {
    sum_j += stiffness / 2 * std::pow(strain_limit * rest_length_m, 2);
  });
  return sum_j;
}

}  // namespace ribbon

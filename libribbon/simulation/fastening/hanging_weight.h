// How far a ribbon is stretched by what hangs from it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/rest_size.h"
#include "scene/scene.h"

namespace ribbon {

// A ribbon that hangs in equilibrium over whatever, without friction, bears at each of its rows the
// weight that lies lower towards the end of its half: as much as would hang straight down from
// there to the height of that end.
class HangingWeight {
 public:
  // particle_mass_kg: mean.
  HangingWeight(const RestSize& size, const SpringScene& stiffness, double particle_mass_kg,
                const Eigen::Vector3d& gravity_m_s2);

  // One for each row but the last: by how much of their rest length the springs would give, from
  // that row to the next, under that weight alone. Infinite where there are no springs along.
  // positions: 3 x particles.
  const std::vector<double>& strains(const Eigen::Matrix3Xd& positions);

 private:
  RibbonGrid grid_;
  Eigen::Vector3d row_weight_n_;      // of a row of mean width
  std::vector<double> heaviness_;     // of each row, over that
  std::vector<double> resistance_n_;  // of each row to being stretched along: force over strain
  std::vector<double> strains_;
};

// Of the scene's gravity; nothing without it.
std::optional<HangingWeight> hanging_weight(const Scene& scene, const RestSize& size,
                                            double particle_mass_kg);

}  // namespace ribbon

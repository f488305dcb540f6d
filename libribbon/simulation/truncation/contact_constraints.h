// Contact as the smoothing knows it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "geometry/ribbon_grid.h"
#include "simulation/contact/pair_gaps.h"
#include "simulation/state/cloth.h"
#include "simulation/truncation/row_activity.h"
#include "simulation/truncation/surroundings.h"

namespace ribbon {

// Over the four vertices of a pair, normal . sum(weights[k] * x_k) shall be at least gap_m.
struct ContactConstraint {
  std::array<int, 4> vertices{};
  Eigen::Vector4d weights = Eigen::Vector4d::Zero();
  Eigen::Vector4d shares =
      Eigen::Vector4d::Zero();  // of a lack, that each vertex makes up for; 0 for the obstacle's
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double gap_m = 0;
};

// One for each listed pair that could come into contact between `certified` and the cloth's present
// positions: along the line between its closest points at `certified`, contact shall not begin, or,
// where it has begun, not become any closer.
std::vector<ContactConstraint> contact_constraints(const Surroundings& surroundings,
                                                   const PairGaps& gaps, double reach_m,
                                                   const Eigen::Matrix3Xd& certified,
                                                   const Cloth& cloth);

// One sweep: moves apart, in order and by momentum conservation, the pairs that do not keep their
// gap, whose rows become active. Did any lack more than a thousandth of it?
bool keep_apart(std::span<const ContactConstraint> constraints, const RibbonGrid& grid,
                RowActivity& activity, Eigen::Matrix3Xd& positions);

}  // namespace ribbon

// Strain correction with the gate: every edge near its rest length, where contact is in the way
// (cf. paper, section 5.5).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ribbon_mesh/springs.h"
#include "simulation/truncation/row_activity.h"

namespace ribbon {

struct LimitedFamily {
  SpringFamily family;
  double limit = 0;  // of the rest length, in both directions

  [[nodiscard]] double shortest_m() const { return (1 - limit) * family.rest_length_m; }
  [[nodiscard]] double longest_m() const { return (1 + limit) * family.rest_length_m; }
};

// PublishedStrainCorrection does not know of contact and therefore moves along the smoothed
// surface. These constraints take turns with those of contact and move along the edges.
class StrainConstraints {
 public:
  StrainConstraints(const RibbonGrid& grid, std::vector<LimitedFamily> families);

  // One sweep: both particles of each edge beyond the limit move toward or away from each other by
  // equal parts, one family after the other; rows that rest are passed over. Was any beyond it by
  // more than a five-hundredth of its length?
  bool tighten(RowActivity& activity, Eigen::Matrix3Xd& positions) const;

  // Of the rows at the beginning of some sweeps.
  [[nodiscard]] RowActivity activity() const { return {grid_.along, families_.size()}; }

  // The most by which the |strain| of an edge is beyond its limit; below 0 where none is.
  [[nodiscard]] double worst_excess(const Eigen::Matrix3Xd& positions) const;

 private:
  RibbonGrid grid_;
  std::vector<LimitedFamily> families_;
};

// What the strain correction aims at for an edge of rest length rest_m, so that it is still within
// the paper's limit of 10 % when it is left a little over and then recorded with rounding_m (>= 0)
// a coordinate: `strain`, or what rounding leaves, but not less than 2 %. Such short edges may be
// recorded beyond the limit.
double aimed_strain(double strain, double rest_m, double rounding_m);

// By how much more than what was aimed at the strain correction is content with.
inline constexpr double strain_left_over = 0.008;

}  // namespace ribbon

// Strain correction with the gate: every edge near its rest length, where contact is in the way
// (cf. paper, section 5.5).
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "ribbon_mesh/springs.h"
#include "simulation/state/cloth.h"
#include "simulation/truncation/sweep_activity.h"

namespace ribbon {

// Strains are parts of the rest length, in both directions.
struct LimitedFamily {
  SpringFamily family;
  double aimed = 0;  // what the correction aims at
  double most = 0;   // what no step may leave
};

// Of all edges.
struct StrainExcess {
  // The most by which the |strain| of an edge is beyond what is aimed at; below 0 where none is.
  double beyond_aimed = -std::numeric_limits<double>::infinity();
  bool is_bearable = true;  // is every edge within what no step may leave?
};

// PublishedStrainCorrection does not know of contact and therefore moves along the smoothed
// surface. These constraints take turns with those of contact and move along the edges.
class StrainConstraints {
 public:
  StrainConstraints(const RibbonGrid& grid, std::vector<LimitedFamily> families);

  // One sweep: both particles of each edge beyond what is aimed at move toward or away from each
  // other by equal parts (over-relaxed, up to its rest length), and lose the speed at which it gets
  // further beyond, so that kinetic energy never grows; one family after the other; rows that rest
  // are passed over. Was any beyond it by more than 0.4 % of its length?
  bool tighten(SweepActivity& activity, Cloth& cloth) const;

  // To what they bring every edge where nothing is in the way, as a fraction of its rest length:
  // that of the family with the least. Infinite without edges.
  [[nodiscard]] double least_held() const;

  // At the beginning of some sweeps.
  [[nodiscard]] SweepActivity activity() const {
    return {grid_, first_family_task + families_.size()};
  }

  [[nodiscard]] StrainExcess excess(const Eigen::Matrix3Xd& positions) const;

 private:
  RibbonGrid grid_;
  std::vector<LimitedFamily> families_;
};

// The most strain of an edge of rest length rest_m that stays within the paper's limit of 10 % when
// it is recorded with rounding_m (>= 0) a coordinate; at least what the correction leaves.
double most_strain(double rest_m, double rounding_m);

// With up to which rounding edges of rest_m are kept within the paper's limit by aiming at `strain`
// (at least least_aimed_strain).
double coarsest_rounding_m(double rest_m, double strain);

// The strain correction aims no lower, however short the edges.
inline constexpr double least_aimed_strain = 0.02;

// What the strain correction aims at for an edge of rest length rest_m, so that it is still within
// most_strain() when it is left a little over: `strain`, or less where rounding asks for it.
double aimed_strain(double strain, double rest_m, double rounding_m);

// By how much more than what was aimed at the strain correction is content with.
inline constexpr double strain_left_over = 0.008;

}  // namespace ribbon

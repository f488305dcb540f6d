// Keeping every edge near its natural length where contact is in the way (cf. paper, section 5.5).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ribbon_mesh/springs.h"

namespace ribbon {

// The published correction, which is told apart as StrainCorrection, does not know of contact and
// therefore moves along the smoothed surface. This one takes turns with contact and moves along the
// edges.
class StrainLimit {
 public:
  // limit: of the natural length, in both directions.
  StrainLimit(std::vector<Spring> edges, double limit);

  // One sweep: both particles of each edge beyond the limit move toward or away from each other by
  // equal parts, in order. Was any beyond it by more than a five-hundredth of its length?
  bool tighten(Eigen::Matrix3Xd& positions) const;

  // The largest |length / natural length - 1|.
  [[nodiscard]] double worst(const Eigen::Matrix3Xd& positions) const;

 private:
  std::vector<Spring> edges_;
  double limit_;
};

}  // namespace ribbon

// Watches a ribbon frame by frame and certifies that its knot is still the same.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/centre_axis.h"
#include "geometry/ribbon_grid.h"
#include "knot/knot_certificate.h"
#include "knot/motion/axis_turns.h"
#include "knot/motion/closing_rays.h"
#include "knot/motion/ribbon_curves.h"
#include "knot/motion/selvage_linking.h"

namespace ribbon {

// Shares no code with the simulation. The closure is described in docs/knot-certificate.md.
class KnotWitness {
 public:
  // Without `axis`, turns about it are not counted.
  KnotWitness(const RibbonGrid& grid, const std::optional<CentreAxis>& axis);

  // The next frame: 3 x grid.particle_count() positions. To be called with every frame in order,
  // because it follows the ends, so that the closure is the same from frame to frame. Between two
  // frames, every particle is taken to move straight, and an end to turn less than half a turn.
  void follow(const Eigen::Matrix3Xf& positions);

  // Of the frame followed last. Requires at least one.
  [[nodiscard]] KnotCertificate certificate() const;

 private:
  RibbonGrid grid_;
  std::optional<RibbonCurves> curves_;  // of the frame followed last
  ClosingRays rays_;
  SelvageLinking selvages_;
  std::optional<AxisTurns> turns_;
  bool broken_positions_ = false;
};

}  // namespace ribbon

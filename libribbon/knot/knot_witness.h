// Watches a ribbon frame by frame and certifies that its knot is still the same.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/object_axis.h"
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
  // Without `axis`, turns round an object are not counted.
  KnotWitness(const RibbonGrid& grid, const std::optional<ObjectAxis>& axis);

  // The next frame: 3 x grid.particle_count() positions. To be called with every frame in order,
  // because it follows the ends, so that the closure is the same from frame to frame. Between two
  // frames, every particle is taken to move straight, and an end to turn the shorter way.
  void follow(const Eigen::Matrix3Xf& positions);

  // Is an end buried, in the frame followed last or before?
  [[nodiscard]] bool is_buried() const { return rays_.any_buried(); }
  // Of the frame before the one in which first an end got buried: the last that a closure tells.
  // Nothing if there is none.
  [[nodiscard]] const std::optional<KnotCertificate>& last_closed() const { return last_closed_; }
  // As KnotCertificate has it.
  [[nodiscard]] bool may_have_passed() const { return may_have_passed_; }

  // Of the frame followed last. Requires at least one.
  [[nodiscard]] KnotCertificate certificate() const;

  // So far. The certificates of two frames differ by up to one in how often the selvages are linked
  // for each that lies between them, though nothing has passed through anything.
  [[nodiscard]] int wide_turns() const { return selvages_.wide_turns(); }

  // Nothing without an axis.
  [[nodiscard]] const std::optional<AxisTurns>& turns() const { return turns_; }

 private:
  void follow_motion(const RibbonCurves& now);

  RibbonGrid grid_;
  std::optional<RibbonCurves> curves_;  // of the frame followed last
  ClosingRays rays_;
  SelvageLinking selvages_;
  std::optional<AxisTurns> turns_;
  std::optional<KnotCertificate> last_closed_;
  bool may_have_passed_ = false;
  bool broken_positions_ = false;
};

}  // namespace ribbon

#include "knot/knot_witness.h"

#include <cassert>
#include <utility>

#include "knot/motion/straight_motion.h"
#include "knot/type/closed_by_rays.h"

namespace ribbon {
namespace {

// Does straight motion show that the knot and the twist are what they were, wherever the ends are?
// In frames that do not intersect, the selvages are linked as the line beside the centre is with
// it.
bool nothing_passes(const RibbonCurves& before, const RibbonCurves& now) {
  const MovingCurve centre_line{before.centre_line, now.centre_line};
  return stays_clear_of_itself(centre_line) &&
         stay_clear(centre_line, {before.beside_centre, now.beside_centre});
}

}  // namespace

KnotWitness::KnotWitness(const RibbonGrid& grid, const std::optional<ObjectAxis>& axis)
    : grid_(grid) {
  assert(grid.along >= 2 && grid.across >= 2);
  if (axis) turns_.emplace(*axis);
}

void KnotWitness::follow(const Eigen::Matrix3Xf& positions) {
  assert(positions.cols() == grid_.particle_count());
  broken_positions_ = broken_positions_ || !positions.allFinite();
  if (broken_positions_) return;
  RibbonCurves now = ribbon_curves(grid_, positions);
  if (curves_) {
    follow_motion(now);
  } else {
    rays_.start(now);
    selvages_.start(now, rays_.directions());
  }
  if (turns_) turns_->follow(centre_line(grid_, positions));
  curves_ = std::move(now);
}

void KnotWitness::follow_motion(const RibbonCurves& now) {
  ClosingRays rays = rays_;
  rays.follow(*curves_, now);
  if (rays.any_buried() && !rays_.any_buried()) last_closed_ = certificate();
  rays_ = rays;
  if (!is_buried())
    selvages_.follow(*curves_, now, rays_.directions());
  else if (!may_have_passed_)
    may_have_passed_ = !nothing_passes(*curves_, now);
}

KnotCertificate KnotWitness::certificate() const {
  assert(curves_ || broken_positions_);
  KnotCertificate result;
  result.broken_positions = broken_positions_;
  if (broken_positions_) return result;
  result.first_end_buried = rays_.buried()[0];
  result.last_end_buried = rays_.buried()[1];
  if (turns_) {
    result.turns_round_object = turns_->turns();
    result.object_met = turns_->met();
  }
  result.may_have_passed = may_have_passed_;
  if (is_buried()) return result;
  result.selvage_linking = selvages_.number();
  result.jones = type_closed_by(rays_.directions(), curves_->centre_line);
  return result;
}

}  // namespace ribbon

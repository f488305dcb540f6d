#include "recorder/tying.h"

#include "knot/knot_witness.h"

namespace ribbon {

Result<void> check_tying(const RibbonGrid& grid, const std::optional<CentreAxis>& axis,
                         const Eigen::Matrix3Xd& drawn, const Eigen::Matrix3Xd& start) {
  KnotWitness witness(grid, axis);
  witness.follow(drawn.cast<float>());
  const KnotCertificate before = witness.certificate();
  witness.follow(start.cast<float>());
  const KnotCertificate after = witness.certificate();
  if (before.jones && before.jones == after.jones &&
      before.turns_about_axis == after.turns_about_axis && before.axis_met == after.axis_met)
    return {};
  return failure(
      "",
      "moving the ribbon out of what it pierced changed how it is tied, from " + before.text() +
          " to " + after.text(),
      "draw the ribbon around the obstacle, or move the obstacle with obstacle.position");
}

}  // namespace ribbon

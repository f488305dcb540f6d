#include "recorder/run/tied_as_drawn.h"

#include "knot/knot_witness.h"

namespace ribbon {

Result<void> check_tied_as_drawn(const RibbonGrid& grid, const std::optional<ObjectAxis>& axis,
                                 const Eigen::Matrix3Xd& drawn, const Eigen::Matrix3Xd& start) {
  KnotWitness witness(grid, axis);
  witness.follow(drawn.cast<float>());
  const KnotCertificate before = witness.certificate();
  witness.follow(start.cast<float>());
  KnotCertificate after = witness.certificate();
  // A start that was moved over an end of the object is not tied as drawn either.
  if (witness.turns()) *after.turns_round_object += witness.turns()->turns_over_ends();
  if (before.jones && before.jones == after.jones &&
      before.turns_round_object == after.turns_round_object &&
      before.object_met == after.object_met)
    return {};
  return failure(
      "",
      "moving the ribbon out of what it pierced changed how it is tied, from " + before.text() +
          " to " + after.text(),
      "draw the ribbon around the obstacle, or move the obstacle with obstacle.position");
}

}  // namespace ribbon

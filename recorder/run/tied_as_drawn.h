// Is the ribbon still tied as it was drawn?
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/object_axis.h"
#include "geometry/ribbon_grid.h"
#include "result/result.h"

namespace ribbon {

// A start that was moved out of what it pierced could have been moved through itself or to the
// other side of the object. Compares the knot of its centre line and its turns round the object
// with those as drawn (3 x particles each; the selvages of a drawn band may pierce something, its
// centre line does not). Fails, saying how, where they differ or are not known.
Result<void> check_tied_as_drawn(const RibbonGrid& grid, const std::optional<ObjectAxis>& axis,
                                 const Eigen::Matrix3Xd& drawn, const Eigen::Matrix3Xd& start);

}  // namespace ribbon

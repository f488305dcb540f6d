#include "knot/type/view_crossing.h"

namespace ribbon {

ViewCrossing view_crossing(const ProjectivePoint& p, const ProjectivePoint& q,
                           const ProjectivePoint& r, const ProjectivePoint& s,
                           const ProjectivePoint& view) {
  const int r_side = orientation(p, q, r, view);
  const int s_side = orientation(p, q, s, view);
  if (r_side * s_side > 0) return {};
  const int p_side = orientation(r, s, p, view);
  const int q_side = orientation(r, s, q, view);
  if (p_side * q_side > 0) return {};
  // (q - p) x (s - r) points to the viewer where s is on the left of pq. Over x under points to him
  // at right-handed crossings.
  const int sign = orientation(p, q, r, s);
  if (r_side * s_side * p_side * q_side * sign == 0) return {ViewOfEdges::doubtful, 0, false};
  return {ViewOfEdges::crossing, sign, sign == s_side};
}

}  // namespace ribbon

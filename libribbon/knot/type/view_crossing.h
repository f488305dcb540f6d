// Two edges as a viewer sees them: do they cross, and how?
#pragma once

#include "exact/orientation.h"

namespace ribbon {

enum class ViewOfEdges { apart, crossing, doubtful };

struct ViewCrossing {
  ViewOfEdges seen = ViewOfEdges::apart;
  int sign = 0;             // of a crossing: 1 right-handed, -1 left-handed
  bool first_over = false;  // is the first edge nearer to the viewer?
};

// Edges p to q and r to s, seen from the direction `view`. Exact. "Doubtful" is a view in which an
// end of one lies on the line of the other, or edges that meet in space: another view is needed.
ViewCrossing view_crossing(const ProjectivePoint& p, const ProjectivePoint& q,
                           const ProjectivePoint& r, const ProjectivePoint& s,
                           const ProjectivePoint& view);

}  // namespace ribbon

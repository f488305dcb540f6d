// Verifies frames of a recording by themselves, knowing nothing of how they came about.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/limited_edges.h"
#include "geometry/rest_size.h"
#include "geometry/triangle_mesh.h"
#include "verification/box_tree.h"
#include "verification/feature_owners.h"
#include "verification/intersecting_pairs.h"
#include "verification/largest_strain.h"
#include "verification/layer_gaps.h"
#include "verification/smallest_gap.h"
#include "verification/triangle_soup.h"

namespace ribbon {

// Where one coordinate is not a finite number nothing else can be said, and the rest is empty.
struct FrameVerdict {
  bool finite = false;
  // Triangle t is the ribbon's t-th where t < grid.triangle_count(), otherwise it is the obstacle's
  // (t - grid.triangle_count())-th.
  IntersectingPairs intersections;
  SmallestGap gap;       // 0 where triangles intersect
  LargestStrain strain;  // of the limited edges
};

class FrameVerifier {
 public:
  // The ribbon's size at rest, of at least 2 x 2 particles, an obstacle whose positions are
  // finite and whose triangles may be as bad as they like, and the edges whose strain is measured.
  explicit FrameVerifier(RestSize size, const std::optional<TriangleMesh>& obstacle = std::nullopt,
                         const LimitedEdges& limited = {});

  // At most so many intersecting pairs are listed per frame.
  static constexpr std::size_t most_pairs = 100'000;

  // positions: 3 x particles. May be called from several threads at a time.
  [[nodiscard]] FrameVerdict verify(const Eigen::Matrix3Xf& positions) const;

  // Does the ribbon, at positions that must be finite, meet itself or the obstacle? A part of
  // verify() that takes less time.
  [[nodiscard]] bool intersects(const Eigen::Matrix3Xf& positions) const;

  // What is verified: the ribbon at `positions`, judged, and the obstacle.
  [[nodiscard]] TriangleSoup soup(const Eigen::Matrix3Xf& positions) const;

  // Gaps of single particles at `positions`, which must be finite. This must outlive them.
  [[nodiscard]] LayerGaps layer_gaps(const Eigen::Matrix3Xf& positions) const;

 private:
  RestSize size_;
  LimitedEdges limited_;
  TriangleSoup soup_;  // the ribbon's points are still to be filled in
  FeatureOwners owners_;
  BoxTree obstacle_;
};

}  // namespace ribbon

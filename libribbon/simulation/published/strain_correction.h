// Strain correction as published: post-step and geometric (paper, section 5.5, Figure 9).
#pragma once

#include <Eigen/Core>

#include "ribbon_mesh/springs.h"
#include "simulation/state/smoothed_tangents.h"

namespace ribbon {

// The correction of one ribbon: edges along and across are brought back within `limit` of their
// rest length. Keeps its memory.
class PublishedStrainCorrection {
 public:
  PublishedStrainCorrection(const RestSize& size, double limit);

  // Is any edge along or across longer or shorter than the limit allows?
  [[nodiscard]] bool any_over_limit(const Eigen::Matrix3Xd& positions) const;

  // One round: both particles of each edge over the limit move toward or away from each other by
  // equal parts, first all edges along the ribbon and then all across, in the direction of the
  // smoothed surface rather than of the edge, so that particles do not leave the surface.
  void apply(Eigen::Matrix3Xd& positions);

 private:
  [[nodiscard]] bool any_over_limit(const SpringFamily& family,
                                    const Eigen::Matrix3Xd& positions) const;
  // Signed change of length that brings an edge back within the limit; 0 within it.
  [[nodiscard]] double excess_m(double length_m, double rest_length_m) const;
  void correct_edge(int a, int b, double rest_length_m, const Eigen::Vector3d& smoothed,
                    Eigen::Matrix3Xd& positions) const;

  RibbonGrid grid_;
  SpringFamily along_;
  SpringFamily across_;
  double limit_;
  SmoothedTangents tangents_;
};

}  // namespace ribbon

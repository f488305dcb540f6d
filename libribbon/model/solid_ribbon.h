// The ribbon as a closed solid.
#pragma once

#include <Eigen/Core>
#include <mutex>
#include <optional>

#include "geometry/ribbon_grid.h"
#include "verification/box_tree.h"
#include "verification/feature_owners.h"
#include "verification/triangle_soup.h"

namespace ribbon {

// Its vertices are the front's, in the order of the particles, then the back's likewise. Front and
// back lie half the thickness away from the recorded surface, along normals that look away from all
// triangles around a particle; where other features are nearer, half the way to them at most. Where
// the cloth is so crumpled that there is no such direction, the solid is pinched: front and back of
// that particle lie on it, in the same position, and touch.
class SolidRibbon {
 public:
  // obstacle: 3 x vertices and 3 x triangles, none where there is none; in the ribbon's unit, as is
  // the thickness.
  SolidRibbon(const RibbonGrid& grid, double thickness, const Eigen::Matrix3Xf& obstacle_vertices,
              const Eigen::Matrix3Xi& obstacle_triangles);

  // 3 x 2 particles, of a surface that is 3 x particles. Certain: of the solid's triangles and the
  // obstacle's no two meet, but for two of the obstacle (exact predicates judge the positions as
  // they are rounded), if front and back of a pinched particle count as one vertex. Nothing where
  // that cannot be had: the surface intersects, or all corners of a triangle would be pinched. May
  // be called from several threads at a time.
  [[nodiscard]] std::optional<Eigen::Matrix3Xf> raise(const Eigen::Matrix3Xf& surface) const;

  // At any particle, but for pinched ones, of all that was raised so far; the thickness asked for
  // where nothing was.
  [[nodiscard]] double least_thickness() const;
  // How thick those that could not be raised so far would have to be at least, for single precision
  // to tell front and back apart where they lie; nothing where they were, or all could be raised.
  [[nodiscard]] std::optional<double> told_thickness() const;
  // How many particles were pinched in one surface, at most.
  [[nodiscard]] int most_pinched() const;

 private:
  [[nodiscard]] TriangleSoup surface_soup(const Eigen::Matrix3Xf& surface) const;
  [[nodiscard]] Eigen::ArrayXd heights_between_layers(const TriangleSoup& surface) const;
  void note(const Eigen::ArrayXd& heights) const;
  void note_refused(const Eigen::Matrix3Xf& surface) const;

  RibbonGrid grid_;
  double thickness_;
  TriangleSoup surface_;  // the ribbon's points are still to be filled in
  TriangleSoup solid_;    // likewise
  FeatureOwners owners_;
  BoxTree surface_rest_;
  BoxTree solid_rest_;
  mutable std::mutex mutex_;
  mutable double least_thickness_;
  mutable float refused_reach_ = 0;  // largest coordinate of what was free and could not be raised
  mutable int most_pinched_ = 0;
};

}  // namespace ribbon

// How far edges are stretched or shrunk from their rest length.
#pragma once

#include <Eigen/Core>

#include "geometry/vectors.h"
#include "ribbon_mesh/springs.h"

namespace ribbon {

// By how much of its rest length the paper lets an edge be longer or shorter (section 5.5).
inline constexpr double paper_strain_limit = 0.1;

// (length - rest length) / rest length of the edge from particle a to b of a family; above 0 where
// it is stretched. positions, here and below: 3 x particles.
inline double edge_strain(const SpringFamily& family, int a, int b,
                          const Eigen::Matrix3Xd& positions) {
  return length_of(positions.col(b) - positions.col(a)) / family.rest_m(a) - 1;
}

// The largest |strain| of a family's edges.
double worst_strain(const RibbonGrid& grid, const SpringFamily& family,
                    const Eigen::Matrix3Xd& positions);

// Of the stretch and shear springs, as far as they have stiffness; 0 without any. Bending springs
// shorten wherever cloth folds: that is no strain.
double worst_strain(const SpringNetwork& springs, const Eigen::Matrix3Xd& positions);

// By how much of their length the edges along the ribbon change in a second, in the root mean
// square: they stretch, shrink and turn. velocities: 3 x particles, m/s.
double change_per_s(const RibbonGrid& grid, const Eigen::Matrix3Xd& positions,
                    const Eigen::Matrix3Xd& velocities);

}  // namespace ribbon

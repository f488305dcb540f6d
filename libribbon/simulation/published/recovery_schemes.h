// Schemes A, B and C: how penetrations of each pattern are removed (paper, section 5.6.3).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/detection/bodies.h"
#include "simulation/published/penetration.h"

namespace ribbon {

// Scheme A, for ribbon edges that pierce the obstacle. Of each edge the particle that fewer sound
// neighbouring edges speak for (of two equal ones the deeper) is moved along the obstacle's outward
// normal by its distance from the pierced triangle, and gap_m beyond. Triangles that it lies in
// front of do not move it; where it lies in front of all, the edge's other particle moves.
void apply_scheme_a(const RibbonGrid& grid, const CollisionSurface& ribbon,
                    const ObstacleBody& obstacle,
                    const std::vector<Penetration>& ribbon_into_obstacle, double gap_m,
                    Eigen::Matrix3Xd& positions);

// Is this edge part of a selvage or of an end of the ribbon?
bool is_border_edge(const RibbonGrid& grid, const std::array<int, 2>& edge);

// Scheme B, for border edges that pierce the ribbon: the border shrinks and curls. Each penetrating
// particle moves `step_m` in the mean direction of the edges from it across the ribbon, up to the
// first folding particle or, without one, to the other border; its neighbours across and along move
// with it, less with distance. For the two ends of the ribbon, along takes the place of across.
void apply_scheme_b(const RibbonGrid& grid, const CollisionSurface& ribbon,
                    const std::vector<Penetration>& self_penetrations, double step_m,
                    Eigen::Matrix3Xd& positions);

// Scheme C, for all edges that pierce the ribbon. The side of the pierced triangle on which the
// majority of the neighbouring particles lies is right; the edge's particle on the other side moves
// there along the triangle's normal, and gap_m beyond.
void apply_scheme_c(const RibbonGrid& grid, const CollisionSurface& ribbon,
                    const std::vector<Penetration>& self_penetrations, double gap_m,
                    Eigen::Matrix3Xd& positions);

}  // namespace ribbon

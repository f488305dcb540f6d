// Meshes with the normals that make them look smooth.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/ribbon_grid.h"
#include "geometry/triangle_mesh.h"

namespace ribbon {

struct Surface {
  Eigen::Matrix3Xf vertices;   // 3 x V, metres
  Eigen::Matrix3Xf normals;    // 3 x V, unit length, to the front (outside); zero where none exists
  Eigen::Matrix3Xi triangles;  // 3 x T, counter-clockwise about the front
};

// The ribbon with its triangles and no positions yet.
Surface ribbon_surface(const RibbonGrid& grid);

// Moves the ribbon: positions is 3 x particles.
void update_ribbon(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions, Surface& ribbon);

// Adds strips that stand upright along both selvages, so that the cloth's thickness is seen there.
// Their vertices follow the particles: of each row the first selvage's back and front, then the
// second's.
void add_selvages(const RibbonGrid& grid, Surface& ribbon);

// Moves them with the ribbon, whose normals must be there. half_thickness_m: by how much they rise
// above each particle of the ribbon, and as much below.
void update_selvages(const RibbonGrid& grid, const std::vector<float>& half_thickness_m,
                     Surface& ribbon);

// The particle that a vertex of a ribbon with selvages follows.
int particle_of(const RibbonGrid& grid, int vertex);

// Smooth where neighbouring triangles meet at less than 40 degrees, sharp elsewhere: a cylinder's
// side is round and its rim is not. Corners are not shared between triangles.
Surface creased_surface(const TriangleMesh& mesh);

// The vertices and triangles of both, those of the first first.
Surface joined(const Surface& first, const Surface& second);

}  // namespace ribbon

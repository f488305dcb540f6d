// The faces of an exported ribbon.
#pragma once

#include <Eigen/Core>

#include "geometry/ribbon_grid.h"

namespace ribbon {

// How the ribbon is divided. A recording certifies its triangles. Quads begin at the corner from
// which a fan splits them into the same triangles, but a reader may split them otherwise.
enum class RibbonFaces { triangles, quads };

// Corners x faces: of the recorded surface.
Eigen::MatrixXi surface_faces(const RibbonGrid& grid, RibbonFaces faces);

// Of a solid whose front has the particles' numbers and whose back those behind them: front, rim,
// then the back.
Eigen::MatrixXi solid_faces(const RibbonGrid& grid, RibbonFaces faces);

}  // namespace ribbon

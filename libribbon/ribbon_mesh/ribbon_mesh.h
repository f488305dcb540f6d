// A centre line with width: the particles of the ribbon at the start (paper, section 4.2, Figure
// 4).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "curve/space_curve.h"
#include "geometry/rest_size.h"
#include "geometry/ribbon_grid.h"
#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

struct RibbonMesh {
  RibbonGrid grid;
  Eigen::Matrix3Xd curve;                   // 3 x along, metres: the centre line that it was put on
  Eigen::Matrix3Xd positions;               // 3 x particles, metres
  Eigen::Matrix2Xf uv;                      // 2 x particles: u along, v across, both from 0 to 1
  double length_m = 0;                      // of the flat band
  double width_m = 0;                       // mean of its rows
  std::vector<double> row_widths_m;         // as in RestSize
  std::vector<Crossing> crossings;          // of the drawing
  std::vector<ObjectPassage> objects = {};  // likewise
  std::vector<double> passage_shares = {};  // of its length, where passages_along() them are
  std::optional<Error> squeezed = std::nullopt;  // the drawing's passage that is too tight for it

  [[nodiscard]] RestSize size() const { return {grid, length_m, width_m, row_widths_m}; }
};

// Reads the drawing of the scene and puts the ribbon on it. Passages that are too tight are
// squeezed where the gate grows the ribbon into them, and refused where contact is as published.
// Fails where the drawing does not work. obstacle: that of the scene.
Result<RibbonMesh> draw_ribbon(const Scene& scene,
                               const std::optional<TriangleMesh>& obstacle = std::nullopt);

// Puts `ribbon.across` particles on the width line of each of the curve's points. The curve must
// have been sampled with `ribbon.along` points; axis: the one its crossings were pulled apart
// along.
RibbonMesh generate_ribbon_mesh(const SpaceCurve& curve, const RibbonScene& ribbon, Axis axis);

}  // namespace ribbon

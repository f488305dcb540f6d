// Lines as the preview's shader takes them: bands of triangles that it widens on the screen.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "player/preview/wire_edges.h"

namespace ribbon {

// How many numbers each input of the shader takes: position, before, after, side, face, other face.
inline const std::vector<int> line_parts = {3, 3, 3, 1, 3, 3};

struct LineBands {
  Eigen::MatrixXf vertices;  // one a column
  Eigen::Matrix3Xi triangles;
};

// Each edge by itself.
LineBands bands_of(const std::vector<WireEdge>& edges);

// Through all points (3 x at least 2), one after the other, without gaps where it bends. It is
// never faint.
LineBands band_through(const Eigen::Matrix3Xf& points);

}  // namespace ribbon

#include "player/preview/line_bands.h"

#include <algorithm>

namespace ribbon {

namespace {

using Vertex = Eigen::Matrix<float, 16, 1>;

// Of the four corners of a band: both sides of its beginning, then of its end.
void put_triangles(int corner, Eigen::Index band, Eigen::Matrix3Xi& triangles) {
  triangles.col(2 * band) << corner, corner + 1, corner + 2;
  triangles.col(2 * band + 1) << corner + 2, corner + 1, corner + 3;
}

}  // namespace

LineBands bands_of(const std::vector<WireEdge>& edges) {
  const auto count = static_cast<Eigen::Index>(edges.size());
  LineBands bands{Eigen::MatrixXf(Vertex::RowsAtCompileTime, 4 * count),
                  Eigen::Matrix3Xi(3, 2 * count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const WireEdge& edge = edges[static_cast<std::size_t>(k)];
    for (int corner = 0; corner < 4; ++corner)
      bands.vertices.col(4 * k + corner) << (corner < 2 ? edge.begin : edge.end), edge.begin,
          edge.end, (corner % 2 == 0 ? -1.0F : 1.0F), edge.face, edge.other_face;
    put_triangles(static_cast<int>(4 * k), k, bands.triangles);
  }
  return bands;
}

LineBands band_through(const Eigen::Matrix3Xf& points) {
  const Eigen::Index last = points.cols() - 1;
  LineBands band{Eigen::MatrixXf(Vertex::RowsAtCompileTime, 2 * points.cols()),
                 Eigen::Matrix3Xi(3, 2 * last)};
  const Eigen::Vector3f no_face = Eigen::Vector3f::Zero();
  for (Eigen::Index k = 0; k <= last; ++k) {
    const Eigen::Vector3f before = points.col(std::max<Eigen::Index>(k - 1, 0));
    const Eigen::Vector3f after = points.col(std::min(k + 1, last));
    band.vertices.col(2 * k) << points.col(k), before, after, -1, no_face, no_face;
    band.vertices.col(2 * k + 1) << points.col(k), before, after, 1, no_face, no_face;
    if (k < last) put_triangles(static_cast<int>(2 * k), k, band.triangles);
  }
  return band;
}

}  // namespace ribbon

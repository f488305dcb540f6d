#include "model/ribbon_faces.h"

#include <vector>

namespace ribbon {

namespace {

Eigen::MatrixXi quads_of(const RibbonGrid& grid) {
  Eigen::MatrixXi quads(4, grid.quad_count());
  for (int q = 0; q < grid.quad_count(); ++q) {
    const auto corners = grid.fan(q);
    quads.col(q) << corners[0], corners[1], corners[2], corners[3];
  }
  return quads;
}

// All particles at the rim, in the direction in which the front's faces run round it.
std::vector<int> rim_of(const RibbonGrid& grid) {
  std::vector<int> rim;
  rim.reserve(2 * (static_cast<std::size_t>(grid.along) + grid.across));
  for (int i = 0; i < grid.along - 1; ++i) rim.push_back(grid.particle(i, 0));
  for (int j = 0; j < grid.across - 1; ++j) rim.push_back(grid.particle(grid.along - 1, j));
  for (int i = grid.along - 1; i > 0; --i) rim.push_back(grid.particle(i, grid.across - 1));
  for (int j = grid.across - 1; j > 0; --j) rim.push_back(grid.particle(0, j));
  return rim;
}

// Quads between the rims of front and back, the same way round as the front.
Eigen::MatrixXi rim_quads(const RibbonGrid& grid) {
  const std::vector<int> rim = rim_of(grid);
  const int back = grid.particle_count();
  Eigen::MatrixXi quads(4, static_cast<Eigen::Index>(rim.size()));
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const int here = rim[k];
    const int next = rim[(k + 1) % rim.size()];
    quads.col(static_cast<Eigen::Index>(k)) << next, here, here + back, next + back;
  }
  return quads;
}

Eigen::MatrixXi fans(const Eigen::MatrixXi& quads) {
  Eigen::MatrixXi triangles(3, 2 * quads.cols());
  for (Eigen::Index q = 0; q < quads.cols(); ++q) {
    triangles.col(2 * q) << quads(0, q), quads(1, q), quads(2, q);
    triangles.col(2 * q + 1) << quads(0, q), quads(2, q), quads(3, q);
  }
  return triangles;
}

}  // namespace

Eigen::MatrixXi surface_faces(const RibbonGrid& grid, RibbonFaces faces) {
  if (faces == RibbonFaces::quads) return quads_of(grid);
  return grid.triangles();
}

Eigen::MatrixXi solid_faces(const RibbonGrid& grid, RibbonFaces faces) {
  const Eigen::MatrixXi front = surface_faces(grid, faces);
  const Eigen::MatrixXi rim = faces == RibbonFaces::quads ? rim_quads(grid) : fans(rim_quads(grid));
  Eigen::MatrixXi solid(front.rows(), 2 * front.cols() + rim.cols());
  // The back runs the other way round, from the same corner, so that its diagonals are the same.
  Eigen::MatrixXi back = front.array() + grid.particle_count();
  back.bottomRows(front.rows() - 1) = back.bottomRows(front.rows() - 1).colwise().reverse().eval();
  solid << front, rim, back;
  return solid;
}

}  // namespace ribbon

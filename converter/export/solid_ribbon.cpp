#include "converter/export/solid_ribbon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <vector>

#include "converter/export/ribbon_faces.h"
#include "verification/intersecting_pairs.h"
#include "verification/vertex_room.h"

namespace ribbon {

namespace {

// A little less than half, for what positions are rounded by.
constexpr double part_of_gap = 0.49;
constexpr int most_attempts = 12;  // each halves the height where something still meets
constexpr std::size_t most_pairs = 100'000;

TriangleSoup joined(int points, const Eigen::MatrixXi& faces, const Eigen::Matrix3Xf& obstacle,
                    const Eigen::Matrix3Xi& triangles) {
  TriangleSoup soup;
  soup.judged = static_cast<int>(faces.cols());
  soup.points.setZero(3, points + obstacle.cols());
  soup.points.rightCols(obstacle.cols()) = obstacle;
  soup.triangles.resize(3, faces.cols() + triangles.cols());
  soup.triangles.leftCols(faces.cols()) = faces;
  soup.triangles.rightCols(triangles.cols()) = triangles.array() + points;
  return soup;
}

BoxTree rest_of(const TriangleSoup& soup) {
  return {soup, soup.judged, static_cast<int>(soup.triangles.cols())};
}

Eigen::Matrix3Xd triangle_normals(const TriangleSoup& soup) {
  Eigen::Matrix3Xd normals(3, soup.judged);
  const Eigen::Matrix3Xd points = soup.points.cast<double>();
  for (int t = 0; t < soup.judged; ++t) {
    const Eigen::Vector3d corner = points.col(soup.triangles(0, t));
    normals.col(t) = (points.col(soup.triangles(1, t)) - corner)
                         .cross(points.col(soup.triangles(2, t)) - corner)
                         .stableNormalized();
  }
  return normals;
}

// Turns `normal` until it looks away from all `faces` by more than a tenth, if it can: towards the
// one that it looks away from least, again and again (the perceptron's rule).
Eigen::Vector3d turned_outwards(Eigen::Vector3d normal, const std::vector<Eigen::Vector3d>& faces) {
  constexpr int most_turns = 100;
  for (int turn = 0; turn < most_turns; ++turn) {
    normal.stableNormalize();
    const auto least = std::min_element(
        faces.begin(), faces.end(),
        [&](const auto& a, const auto& b) { return a.dot(normal) < b.dot(normal); });
    if (least->dot(normal) > 0.1) break;
    normal += 0.3 * *least;
  }
  return normal.stableNormalized();
}

// 3 x particles, of length 1.
Eigen::Matrix3Xd outward_normals(const TriangleSoup& soup, int particles) {
  const Eigen::Matrix3Xd of_triangles = triangle_normals(soup);
  std::vector<std::vector<Eigen::Vector3d>> around(particles);
  for (int t = 0; t < soup.judged; ++t)
    for (const int vertex : soup.triangles.col(t)) around[vertex].emplace_back(of_triangles.col(t));
  Eigen::Matrix3Xd normals(3, particles);
  for (int p = 0; p < particles; ++p) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& normal : around[p]) sum += normal;
    normals.col(p) = turned_outwards(sum, around[p]);
  }
  return normals;
}

// Front and back, `heights` away from the surface.
Eigen::Matrix3Xf raised(const Eigen::Matrix3Xd& surface, const Eigen::Matrix3Xd& normals,
                        const Eigen::ArrayXd& heights) {
  const Eigen::Matrix3Xd offsets = normals * heights.matrix().asDiagonal();
  Eigen::Matrix3Xd solid(3, 2 * surface.cols());
  solid << surface + offsets, surface - offsets;
  return solid.cast<float>();
}

void halve_where_they_meet(const std::vector<TrianglePair>& pairs, const TriangleSoup& solid,
                           Eigen::ArrayXd& heights) {
  std::set<int> particles;
  for (const TrianglePair& pair : pairs)
    for (const int triangle : {pair.first, pair.second})
      if (triangle < solid.judged)
        for (const int vertex : solid.triangles.col(triangle))
          particles.insert(vertex % static_cast<int>(heights.size()));
  for (const int particle : particles) heights[particle] /= 2;
}

}  // namespace

SolidRibbon::SolidRibbon(const RibbonGrid& grid, double thickness,
                         const Eigen::Matrix3Xf& obstacle_vertices,
                         const Eigen::Matrix3Xi& obstacle_triangles)
    : grid_(grid),
      thickness_(thickness),
      surface_(joined(grid.particle_count(), surface_faces(grid, RibbonFaces::triangles),
                      obstacle_vertices, obstacle_triangles)),
      solid_(joined(2 * grid.particle_count(), solid_faces(grid, RibbonFaces::triangles),
                    obstacle_vertices, obstacle_triangles)),
      owners_(surface_.triangles),
      surface_rest_(rest_of(surface_)),
      solid_rest_(rest_of(solid_)),
      least_thickness_(thickness) {}

TriangleSoup SolidRibbon::surface_soup(const Eigen::Matrix3Xf& surface) const {
  TriangleSoup soup = surface_;
  soup.points.leftCols(grid_.particle_count()) = surface;
  return soup;
}

Eigen::ArrayXd SolidRibbon::heights_between_layers(const TriangleSoup& surface) const {
  const std::vector<double> room =
      vertex_room(surface, owners_, BoxTree(surface, 0, surface.judged), surface_rest_,
                  thickness_ / part_of_gap);
  const Eigen::Map<const Eigen::ArrayXd> of_particles(room.data(), grid_.particle_count());
  return (part_of_gap * of_particles).min(thickness_ / 2);
}

// Between layers nothing can meet any more. What shares a particle still can, as triangles of front
// and back beside a sharp fold: there the heights are halved until it does not.
Result<Eigen::Matrix3Xf> SolidRibbon::raise(const Eigen::Matrix3Xf& surface) const {
  const TriangleSoup soup = surface_soup(surface);
  const Eigen::Matrix3Xd normals = outward_normals(soup, grid_.particle_count());
  Eigen::ArrayXd heights = heights_between_layers(soup);
  TriangleSoup solid = solid_;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const Eigen::Matrix3Xf positions = raised(surface.cast<double>(), normals, heights);
    solid.points.leftCols(positions.cols()) = positions;
    const BoxTree judged(solid, 0, solid.judged);
    const auto found = intersecting_pairs(solid, judged, solid_rest_, most_pairs);
    if (found.pairs.empty()) {
      note(2 * heights.minCoeff());
      return positions;
    }
    halve_where_they_meet(found.pairs, solid, heights);
  }
  return failure("", "the cloth is folded so sharply that it cannot be given a thickness",
                 "leave --thickness out, or the frame with --frames");
}

void SolidRibbon::note(double thickness) const {
  double least = least_thickness_;
  while (thickness < least && !least_thickness_.compare_exchange_weak(least, thickness)) {
  }
}

}  // namespace ribbon

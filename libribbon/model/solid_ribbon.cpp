#include "model/solid_ribbon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/single_precision.h"
#include "model/outward_direction.h"
#include "model/ribbon_faces.h"
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

// For each particle, of its triangles; one without area says nothing.
std::vector<OutwardDirection> outward_directions(const TriangleSoup& soup, int particles) {
  const Eigen::Matrix3Xd of_triangles = triangle_normals(soup);
  std::vector<std::vector<Eigen::Vector3d>> around(particles);
  for (int t = 0; t < soup.judged; ++t)
    if (!of_triangles.col(t).isZero(0))
      for (const int vertex : soup.triangles.col(t))
        around[vertex].emplace_back(of_triangles.col(t));
  std::vector<OutwardDirection> directions;
  directions.reserve(around.size());
  for (const auto& normals : around) directions.push_back(outward_direction(normals));
  return directions;
}

// Front and back, `heights` away from the surface.
Eigen::Matrix3Xf raised(const Eigen::Matrix3Xd& surface,
                        const std::vector<OutwardDirection>& outwards,
                        const Eigen::ArrayXd& heights) {
  Eigen::Matrix3Xd offsets(3, surface.cols());
  for (Eigen::Index p = 0; p < surface.cols(); ++p)
    offsets.col(p) = heights[p] * outwards[static_cast<std::size_t>(p)].direction;
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

// Where no direction looks away from all triangles around a particle, no vertex above it could see
// all of them: there the solid is as thin as the surface.
void pinch_where_crumpled(const std::vector<OutwardDirection>& outwards, Eigen::ArrayXd& heights) {
  for (std::size_t p = 0; p < outwards.size(); ++p)
    if (outwards[p].least_cosine <= 0) heights[static_cast<Eigen::Index>(p)] = 0;
}

// Front and back of a particle without height are one vertex. Triangles of the rim that have both
// become edges, which others have too: they are put behind those that remain, `judged` in number.
struct Welded {
  TriangleSoup soup;
  int judged;
};

Welded welded(const TriangleSoup& solid, const Eigen::ArrayXd& heights) {
  Welded result{.soup = solid, .judged = 0};
  const auto particles = static_cast<int>(heights.size());
  for (int t = 0; t < solid.judged; ++t) {
    Eigen::Vector3i corners = solid.triangles.col(t);
    for (int& vertex : corners)
      if (vertex >= particles && heights[vertex - particles] == 0) vertex -= particles;
    result.soup.triangles.col(t) = corners;
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    result.soup.triangles.col(t).swap(result.soup.triangles.col(result.judged++));
  }
  return result;
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
std::optional<Eigen::Matrix3Xf> SolidRibbon::raise(const Eigen::Matrix3Xf& surface) const {
  const TriangleSoup soup = surface_soup(surface);
  const auto outwards = outward_directions(soup, grid_.particle_count());
  Eigen::ArrayXd heights = heights_between_layers(soup);
  pinch_where_crumpled(outwards, heights);
  auto [solid, judged_count] = welded(solid_, heights);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const Eigen::Matrix3Xf positions = raised(surface.cast<double>(), outwards, heights);
    solid.points.leftCols(positions.cols()) = positions;
    const BoxTree judged(solid, 0, judged_count);
    const auto found = intersecting_pairs(solid, judged, solid_rest_, most_pairs);
    if (found.pairs.empty()) {
      note(heights);
      return positions;
    }
    halve_where_they_meet(found.pairs, solid, heights);
  }
  if (intersecting_pairs(soup, BoxTree(soup, 0, soup.judged), surface_rest_, 1).pairs.empty())
    note_refused(surface);
  return std::nullopt;
}

void SolidRibbon::note(const Eigen::ArrayXd& heights) const {
  const std::lock_guard lock(mutex_);
  const auto pinched = static_cast<int>((heights == 0).count());
  most_pinched_ = std::max(most_pinched_, pinched);
  if (pinched < heights.size())
    least_thickness_ =
        std::min(least_thickness_, 2 * (heights > 0).select(heights, thickness_).minCoeff());
}

void SolidRibbon::note_refused(const Eigen::Matrix3Xf& surface) const {
  const std::lock_guard lock(mutex_);
  refused_reach_ = std::max(refused_reach_, surface.cwiseAbs().maxCoeff());
}

std::optional<double> SolidRibbon::told_thickness() const {
  constexpr double roundings = 8;  // each side is moved by less than two
  const std::lock_guard lock(mutex_);
  const double least = roundings * largest_rounding(refused_reach_);
  return least > thickness_ ? std::optional(least) : std::nullopt;
}

double SolidRibbon::least_thickness() const {
  const std::lock_guard lock(mutex_);
  return least_thickness_;
}

int SolidRibbon::most_pinched() const {
  const std::lock_guard lock(mutex_);
  return most_pinched_;
}

}  // namespace ribbon

#include "player/render/surface.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <type_traits>
#include <vector>

#include "geometry/first_in_place.h"
#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"

namespace ribbon {

namespace {

Eigen::Vector3f unit_or_zero(const Eigen::Vector3f& vector) {
  const LaneVector unit = unit_or_zero(LaneVector{vector.x(), vector.y(), vector.z()});
  return {unit.x, unit.y, unit.z};
}

// Twice the area, along the normal.
Eigen::Vector3f area_vector(const Eigen::Matrix3Xf& vertices, const Eigen::Vector3i& corners) {
  const Eigen::Vector3f a = vertices.col(corners[0]);
  return (vertices.col(corners[1]) - a).cross(vertices.col(corners[2]) - a);
}

// By the first of the vertices that are in one place: only that counts here.
std::vector<std::vector<int>> triangles_round(const TriangleMesh& mesh,
                                              const std::vector<int>& first) {
  std::vector<std::vector<int>> triangles(first.size());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (const int vertex : mesh.triangles.col(t))
      triangles[first[vertex]].push_back(static_cast<int>(t));
  return triangles;
}

// Column `number` of a matrix with three rows.
[[gnu::always_inline]] inline LaneVector column(const float* columns, std::ptrdiff_t number) {
  return {columns[3 * number], columns[3 * number + 1], columns[3 * number + 2]};
}
[[gnu::always_inline]] inline void set_column(float* columns, std::ptrdiff_t number,
                                              LaneVector to) {
  columns[3 * number] = to.x;
  columns[3 * number + 1] = to.y;
  columns[3 * number + 2] = to.z;
}

// Of each particle's quads the sum. The cross product of a quad's diagonals does not know which way
// the quad is split.
void set_vertex_normals(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions,
                        Eigen::Matrix3Xf& normals) {
  const std::ptrdiff_t across = grid.across;
  const std::ptrdiff_t count = grid.particle_count();
  // Of the quad that begins at each particle; zero where none does, and for particles that would
  // come before the first.
  const std::ptrdiff_t before = across + 1;
  Eigen::Matrix3Xf of_quads(3, before + count);
  const float* const position = positions.data();
  float* const quad = of_quads.data() + 3 * before;
  float* const normal = normals.data();
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (std::ptrdiff_t c = 0; c < count - before; ++c)
      set_column(quad, c,
                 cross(column(position, c + across + 1) - column(position, c),
                       column(position, c + 1) - column(position, c + across)));
  });
  of_quads.leftCols(before).setZero();
  of_quads.rightCols(before).setZero();
  for (int i = 1; i < grid.along; ++i) of_quads.col(i * across - 1 + before).setZero();
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (std::ptrdiff_t c = 0; c < count; ++c)
      set_column(normal, c,
                 unit_or_zero(column(quad, c - across - 1) + column(quad, c - across) +
                              column(quad, c - 1) + column(quad, c)));
  });
}

}  // namespace

Surface ribbon_surface(const RibbonGrid& grid) {
  Surface ribbon;
  ribbon.vertices = Eigen::Matrix3Xf::Zero(3, grid.particle_count());
  ribbon.normals = Eigen::Matrix3Xf::Zero(3, grid.particle_count());
  ribbon.triangles = grid.triangles();
  return ribbon;
}

void update_ribbon(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions, Surface& ribbon) {
  ribbon.vertices.leftCols(positions.cols()) = positions;
  set_vertex_normals(grid, positions, ribbon.normals);
}

void add_selvages(const RibbonGrid& grid, Surface& ribbon) {
  const int first = grid.particle_count();
  const int triangles = grid.triangle_count();
  ribbon.vertices.conservativeResize(Eigen::NoChange, first + 4 * grid.along);
  ribbon.normals.conservativeResize(Eigen::NoChange, first + 4 * grid.along);
  ribbon.triangles.conservativeResize(Eigen::NoChange, triangles + 4 * (grid.along - 1));
  for (int i = 0; i + 1 < grid.along; ++i)
    for (int side = 0; side < 2; ++side) {
      const int back = first + 4 * i + 2 * side;
      const int t = triangles + 4 * i + 2 * side;
      // Counter-clockwise about the outside, which is another way round on either side.
      if (side == 0) {
        ribbon.triangles.col(t) << back, back + 4, back + 5;
        ribbon.triangles.col(t + 1) << back, back + 5, back + 1;
      } else {
        ribbon.triangles.col(t) << back, back + 5, back + 4;
        ribbon.triangles.col(t + 1) << back, back + 1, back + 5;
      }
    }
}

void update_selvages(const RibbonGrid& grid, const std::vector<float>& half_thickness_m,
                     Surface& ribbon) {
  const int first = grid.particle_count();
  for (int i = 0; i < grid.along; ++i)
    for (int side = 0; side < 2; ++side) {
      const int selvage = grid.particle(i, side == 0 ? 0 : grid.across - 1);
      const int inside = grid.particle(i, side == 0 ? 1 : grid.across - 2);
      const Eigen::Vector3f up = half_thickness_m[selvage] * ribbon.normals.col(selvage);
      const Eigen::Vector3f outward =
          unit_or_zero(ribbon.vertices.col(selvage) - ribbon.vertices.col(inside));
      for (int front = 0; front < 2; ++front) {
        const int vertex = first + 4 * i + 2 * side + front;
        ribbon.vertices.col(vertex) = ribbon.vertices.col(selvage) + (front == 0 ? -up : up);
        ribbon.normals.col(vertex) = outward;
      }
    }
}

int particle_of(const RibbonGrid& grid, int vertex) {
  const int beyond = vertex - grid.particle_count();
  if (beyond < 0) return vertex;
  return grid.particle(beyond / 4, beyond % 4 < 2 ? 0 : grid.across - 1);
}

Surface creased_surface(const TriangleMesh& mesh) {
  constexpr float crease_deg = 40;
  const std::vector<int> first = first_in_place(mesh.vertices);
  const auto around = triangles_round(mesh, first);
  const float smooth = std::cos(crease_deg * std::numbers::pi_v<float> / 180.0F);
  const Eigen::Index corners = 3 * mesh.triangles.cols();
  const auto area_of = [&mesh](Eigen::Index triangle) {
    return area_vector(mesh.vertices, mesh.triangles.col(triangle));
  };
  Surface surface{Eigen::Matrix3Xf(3, corners), Eigen::Matrix3Xf(3, corners),
                  Eigen::Matrix3Xi(3, mesh.triangles.cols())};
  std::iota(surface.triangles.data(), surface.triangles.data() + corners, 0);
  for (Eigen::Index corner = 0; corner < corners; ++corner) {
    const int vertex = mesh.triangles(corner % 3, corner / 3);
    const Eigen::Vector3f own = unit_or_zero(area_of(corner / 3));
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const int triangle : around[first[vertex]]) {
      const Eigen::Vector3f other = area_of(triangle);
      if (other.dot(own) >= smooth * other.norm()) sum += other;
    }
    surface.vertices.col(corner) = mesh.vertices.col(vertex);
    surface.normals.col(corner) = unit_or_zero(sum);
  }
  return surface;
}

Surface joined(const Surface& first, const Surface& second) {
  const auto side_by_side = [](const auto& a, const auto& b) {
    std::decay_t<decltype(a)> both(3, a.cols() + b.cols());
    both << a, b;
    return both;
  };
  const auto own = static_cast<int>(first.vertices.cols());
  return {side_by_side(first.vertices, second.vertices),
          side_by_side(first.normals, second.normals),
          side_by_side(first.triangles, Eigen::Matrix3Xi(second.triangles.array() + own))};
}

}  // namespace ribbon

#include "player/render/surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <vector>

#include "parallel/vector_loop.h"
#include "player/render/lane_vector.h"

namespace ribbon {

namespace {

constexpr float least_length = 1e-20F;  // of what still has a direction

Eigen::Vector3f unit_or_zero(const Eigen::Vector3f& vector) {
  const float length = vector.norm();
  return length > least_length ? Eigen::Vector3f(vector / length) : Eigen::Vector3f::Zero();
}

// Twice the area, along the normal.
Eigen::Vector3f area_vector(const Eigen::Matrix3Xf& vertices, const Eigen::Vector3i& corners) {
  const Eigen::Vector3f a = vertices.col(corners[0]);
  return (vertices.col(corners[1]) - a).cross(vertices.col(corners[2]) - a);
}

// Meshes repeat a vertex where texture or normals change; only its position counts here.
std::vector<std::vector<int>> triangles_round_position(const TriangleMesh& mesh,
                                                       std::vector<int>& position_of_vertex) {
  std::map<std::array<float, 3>, int> positions;
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    const Eigen::Vector3f p = mesh.vertices.col(v);
    const auto next = static_cast<int>(positions.size());
    position_of_vertex.push_back(positions.try_emplace({p.x(), p.y(), p.z()}, next).first->second);
  }
  std::vector<std::vector<int>> triangles(positions.size());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (const int vertex : mesh.triangles.col(t))
      triangles[position_of_vertex[vertex]].push_back(static_cast<int>(t));
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

[[gnu::always_inline]] inline LaneVector cross(LaneVector a, LaneVector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The same bits as with Eigen, which sums in this order.
[[gnu::always_inline]] inline LaneVector unit_or_zero(LaneVector vector) {
  const float length = std::sqrt(vector.x * vector.x + (vector.y * vector.y + vector.z * vector.z));
  const bool usable = length > least_length;
  const float divisor = usable ? length : 1.0F;
  return {usable ? vector.x / divisor : 0.0F, usable ? vector.y / divisor : 0.0F,
          usable ? vector.z / divisor : 0.0F};
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

// Neighbouring particles or quads of a row, as many as are worth vector instructions.
struct RowVectors {
  static constexpr int most = 64;
  std::array<float, most> x, y, z;
};

void copy_columns(const float* columns, int first, int count, RowVectors& row) {
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (int j = 0; j < count; ++j) set_lane(row, j, column(columns, first + j));
  });
}

// The unit normals of both triangles of each quad between two rows of particles. `number`: row and
// column of the first quad together, which tell where it is split (RibbonGrid::halves()).
void find_halves(const RowVectors& row, const RowVectors& next, int quads, int number,
                 std::array<RowVectors, 2>& halves) {
  vectorised([&]() RIBBON_INLINED {
    RIBBON_EACH_LANE
    for (int j = 0; j < quads; ++j) {
      const LaneVector a = lane_of(row, j);
      const LaneVector b = lane_of(next, j);
      const LaneVector c = lane_of(next, j + 1);
      const LaneVector d = lane_of(row, j + 1);
      const bool by_ac = ((number + j) & 1) == 0;
      const LaneVector third = {by_ac ? c.x : d.x, by_ac ? c.y : d.y, by_ac ? c.z : d.z};
      const LaneVector first = {by_ac ? a.x : b.x, by_ac ? a.y : b.y, by_ac ? a.z : b.z};
      set_lane(halves[0], j, unit_or_zero(cross(b - a, third - a)));
      set_lane(halves[1], j, unit_or_zero(cross(c - first, d - first)));
    }
  });
}

void set_facets(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions,
                Eigen::Matrix3Xf& facets) {
  const int across = grid.across;
  RowVectors row;
  RowVectors next;
  std::array<RowVectors, 2> halves;
  for (int i = 0; i + 1 < grid.along; ++i)
    for (int first = 0; first + 1 < across; first += RowVectors::most - 1) {
      const int count = std::min(RowVectors::most, across - first);
      copy_columns(positions.data(), grid.particle(i, first), count, row);
      copy_columns(positions.data(), grid.particle(i + 1, first), count, next);
      find_halves(row, next, count - 1, i + first, halves);
      float* const to = facets.data() + std::ptrdiff_t{6} * (i * (across - 1) + first);
      for (int j = 0; j + 1 < count; ++j)
        for (int half = 0; half < 2; ++half) set_column(to, 2 * j + half, lane_of(halves[half], j));
    }
}

}  // namespace

Surface ribbon_surface(const RibbonGrid& grid) {
  Surface ribbon;
  ribbon.vertices = Eigen::Matrix3Xf::Zero(3, grid.particle_count());
  ribbon.normals = Eigen::Matrix3Xf::Zero(3, grid.particle_count());
  ribbon.triangles = grid.triangles();
  ribbon.facets = Eigen::Matrix3Xf::Zero(3, grid.triangle_count());
  return ribbon;
}

void update_ribbon(const RibbonGrid& grid, const Eigen::Matrix3Xf& positions, Surface& ribbon) {
  ribbon.vertices.leftCols(positions.cols()) = positions;
  set_vertex_normals(grid, positions, ribbon.normals);
  set_facets(grid, positions, ribbon.facets);
}

void add_selvages(const RibbonGrid& grid, Surface& ribbon) {
  const int first = grid.particle_count();
  const int triangles = grid.triangle_count();
  ribbon.vertices.conservativeResize(Eigen::NoChange, first + 4 * grid.along);
  ribbon.normals.conservativeResize(Eigen::NoChange, first + 4 * grid.along);
  ribbon.triangles.conservativeResize(Eigen::NoChange, triangles + 4 * (grid.along - 1));
  ribbon.facets.conservativeResize(Eigen::NoChange, triangles + 4 * (grid.along - 1));
  for (int i = 0; i + 1 < grid.along; ++i)
    for (int side = 0; side < 2; ++side) {
      const int back = first + 4 * i + 2 * side;
      const int t = triangles + 4 * i + 2 * side;
      ribbon.triangles.col(t) << back, back + 4, back + 5;
      ribbon.triangles.col(t + 1) << back, back + 5, back + 1;
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
  for (Eigen::Index t = grid.triangle_count(); t < ribbon.triangles.cols(); ++t) {
    const Eigen::Vector3f facet =
        unit_or_zero(area_vector(ribbon.vertices, ribbon.triangles.col(t)));
    const bool outward = facet.dot(ribbon.normals.col(ribbon.triangles(0, t))) >= 0;
    ribbon.facets.col(t) = outward ? facet : Eigen::Vector3f(-facet);
  }
}

int particle_of(const RibbonGrid& grid, int vertex) {
  const int beyond = vertex - grid.particle_count();
  if (beyond < 0) return vertex;
  return grid.particle(beyond / 4, beyond % 4 < 2 ? 0 : grid.across - 1);
}

Surface creased_surface(const TriangleMesh& mesh, float crease_deg) {
  std::vector<int> position_of_vertex;
  const auto around = triangles_round_position(mesh, position_of_vertex);
  const float smooth = std::cos(crease_deg * std::numbers::pi_v<float> / 180.0F);
  const Eigen::Index corners = 3 * mesh.triangles.cols();
  const auto area_of = [&mesh](Eigen::Index triangle) {
    return area_vector(mesh.vertices, mesh.triangles.col(triangle));
  };
  Surface surface{Eigen::Matrix3Xf(3, corners), Eigen::Matrix3Xf(3, corners),
                  Eigen::Matrix3Xi(3, mesh.triangles.cols()),
                  Eigen::Matrix3Xf(3, mesh.triangles.cols())};
  std::iota(surface.triangles.data(), surface.triangles.data() + corners, 0);
  for (Eigen::Index corner = 0; corner < corners; ++corner) {
    const int vertex = mesh.triangles(corner % 3, corner / 3);
    const Eigen::Vector3f own = unit_or_zero(area_of(corner / 3));
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const int triangle : around[position_of_vertex[vertex]]) {
      const Eigen::Vector3f other = area_of(triangle);
      if (other.dot(own) >= smooth * other.norm()) sum += other;
    }
    surface.vertices.col(corner) = mesh.vertices.col(vertex);
    surface.normals.col(corner) = unit_or_zero(sum);
    surface.facets.col(corner / 3) = own;
  }
  return surface;
}

}  // namespace ribbon

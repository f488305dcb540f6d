#include "simulation/published/recovery_schemes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "geometry/vectors.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Displacements that several penetrations ask of the same particle: the longest one counts.
class Moves {
 public:
  void ask(int particle, const Vector3d& displacement) {
    Vector3d& largest = moves_.try_emplace(particle, Vector3d::Zero()).first->second;
    if (squared_length_of(displacement) > squared_length_of(largest)) largest = displacement;
  }
  void apply(Matrix3Xd& positions) const {
    for (const auto& [particle, displacement] : moves_) positions.col(particle) += displacement;
  }

 private:
  std::map<int, Vector3d> moves_;
};

Vector3d unit_normal(const CollisionSurface& surface, int triangle, const Matrix3Xd& positions) {
  const Eigen::Vector3i corners = surface.triangles.col(triangle);
  const Vector3d a = positions.col(corners[0]);
  return normalised((positions.col(corners[1]) - a).cross(positions.col(corners[2]) - a));
}

// Calls visit(particle) for every particle up to `reach` rows and columns away.
template <class Visit>
void visit_neighbourhood(const RibbonGrid& grid, int particle, int reach, const Visit& visit) {
  const int row = grid.row(particle);
  const int column = grid.column(particle);
  for (int i = std::max(0, row - reach); i <= std::min(grid.along - 1, row + reach); ++i)
    for (int j = std::max(0, column - reach); j <= std::min(grid.across - 1, column + reach); ++j)
      visit(grid.particle(i, j));
}

}  // namespace

namespace {

// For each particle: how many of its edges along and across are sound. Diagonals, of which some
// particles have four and others none, do not vote.
std::vector<int> count_sound_edges(const RibbonGrid& grid, const CollisionSurface& ribbon,
                                   const std::vector<Penetration>& penetrations) {
  std::set<int> penetrating;
  for (const Penetration& penetration : penetrations) penetrating.insert(penetration.edge);
  std::vector<int> sound(grid.particle_count(), 0);
  for (std::size_t e = 0; e < ribbon.edges.size(); ++e) {
    const auto [a, b] = ribbon.edges[e];
    const bool diagonal = grid.row(a) != grid.row(b) && grid.column(a) != grid.column(b);
    if (diagonal || penetrating.contains(static_cast<int>(e))) continue;
    ++sound[a];
    ++sound[b];
  }
  return sound;
}

}  // namespace

void apply_scheme_a(const RibbonGrid& grid, const CollisionSurface& ribbon,
                    const ObstacleBody& obstacle,
                    const std::vector<Penetration>& ribbon_into_obstacle, double gap_m,
                    Matrix3Xd& positions) {
  const std::vector<int> sound = count_sound_edges(grid, ribbon, ribbon_into_obstacle);
  const auto outward = [&](const Penetration& penetration) {
    return unit_normal(obstacle.surface, penetration.triangle, obstacle.vertices);
  };
  const auto height_m = [&](const Penetration& penetration, int particle) {
    return dot(outward(penetration), positions.col(particle) - penetration.point);
  };
  // An edge may pierce several triangles: a thin part of the obstacle's front and back.
  std::map<int, std::vector<Penetration>> of_edge;
  for (const Penetration& penetration : ribbon_into_obstacle)
    of_edge[penetration.edge].push_back(penetration);

  Moves moves;
  for (const auto& [edge, penetrations] : of_edge) {
    int penetrating = ribbon.edges[edge][0];
    int other = ribbon.edges[edge][1];
    const int lead = sound[other] - sound[penetrating];
    if (lead < 0 || (lead == 0 && height_m(penetrations.front(), other) <
                                      height_m(penetrations.front(), penetrating)))
      std::swap(penetrating, other);
    // A particle in front of all of them need not move out, whatever the vote says.
    const auto is_behind = [&](const Penetration& p) { return height_m(p, penetrating) <= 0; };
    if (std::none_of(penetrations.begin(), penetrations.end(), is_behind))
      std::swap(penetrating, other);
    for (const Penetration& penetration : penetrations)
      if (is_behind(penetration))
        moves.ask(penetrating, (gap_m - height_m(penetration, penetrating)) * outward(penetration));
  }
  moves.apply(positions);
}

namespace {

bool on_same_selvage(const RibbonGrid& grid, int a, int b) {
  const int column = grid.column(a);
  return column == grid.column(b) && (column == 0 || column == grid.across - 1);
}

bool on_same_end(const RibbonGrid& grid, int a, int b) {
  const int row = grid.row(a);
  return row == grid.row(b) && (row == 0 || row == grid.along - 1);
}

// The line of particles from a border particle straight into the ribbon.
std::vector<int> line_inward(const RibbonGrid& grid, int particle, bool from_end) {
  const int row = grid.row(particle);
  const int column = grid.column(particle);
  std::vector<int> line;
  // From an end, a square piece of ribbon stands for "the other border".
  const int count = from_end ? std::min(grid.along, grid.across) : grid.across;
  line.reserve(count);
  for (int k = 0; k < count; ++k)
    line.push_back(from_end ? grid.particle(row == 0 ? k : grid.along - 1 - k, column)
                            : grid.particle(row, column == 0 ? k : grid.across - 1 - k));
  return line;
}

// Mean of the edges of `line` up to the folding particle, as a unit vector (Figure 13).
Vector3d curling_direction(const std::vector<int>& line, const Matrix3Xd& positions) {
  const auto edge = [&](std::size_t k) {
    return Vector3d(positions.col(line[k + 1]) - positions.col(line[k]));
  };
  const Vector3d first = edge(0);
  Vector3d sum = first;
  for (std::size_t k = 1; k + 1 < line.size() && dot(first, edge(k)) >= 0; ++k) sum += edge(k);
  return normalised(sum);
}

}  // namespace

bool is_border_edge(const RibbonGrid& grid, const std::array<int, 2>& edge) {
  return on_same_selvage(grid, edge[0], edge[1]) || on_same_end(grid, edge[0], edge[1]);
}

void apply_scheme_b(const RibbonGrid& grid, const CollisionSurface& ribbon,
                    const std::vector<Penetration>& self_penetrations, double step_m,
                    Matrix3Xd& positions) {
  constexpr int reach_along = 2;  // rows to either side that help to shape a smooth wrinkle
  const int reach_across = std::max(1, grid.across / 2);
  Moves moves;
  for (const Penetration& penetration : self_penetrations) {
    const auto& edge = ribbon.edges[penetration.edge];
    if (!is_border_edge(grid, edge)) continue;
    const bool from_end = !on_same_selvage(grid, edge[0], edge[1]);
    for (const int penetrating : edge) {
      const Vector3d direction =
          curling_direction(line_inward(grid, penetrating, from_end), positions);
      for (int shift = -reach_along; shift <= reach_along; ++shift) {
        const int row = grid.row(penetrating) + (from_end ? 0 : shift);
        const int column = grid.column(penetrating) + (from_end ? shift : 0);
        if (row < 0 || row >= grid.along || column < 0 || column >= grid.across) continue;
        const double share_along = 1 - std::abs(shift) / (reach_along + 1.0);
        const std::vector<int> line = line_inward(grid, grid.particle(row, column), from_end);
        for (int k = 0; k < std::min<int>(reach_across, static_cast<int>(line.size())); ++k) {
          const double share = share_along * (1 - static_cast<double>(k) / reach_across);
          moves.ask(line[k], share * step_m * direction);
        }
      }
    }
  }
  moves.apply(positions);
}

void apply_scheme_c(const RibbonGrid& grid, const CollisionSurface& ribbon,
                    const std::vector<Penetration>& self_penetrations, double gap_m,
                    Matrix3Xd& positions) {
  constexpr int reach = 2;  // rows and columns whose particles vote on the right side
  Moves moves;
  for (const Penetration& penetration : self_penetrations) {
    const auto& edge = ribbon.edges[penetration.edge];
    Vector3d normal = unit_normal(ribbon, penetration.triangle, positions);
    const auto height_m = [&](int particle) {
      return dot(normal, positions.col(particle) - penetration.point);
    };
    int majority = 0;
    for (const int end : edge)
      visit_neighbourhood(grid, end, reach, [&](int particle) {
        const double height = height_m(particle);
        majority += height > 0 ? 1 : height < 0 ? -1 : 0;
      });
    if (majority < 0) normal *= -1;
    for (const int end : edge)
      if (height_m(end) < 0) moves.ask(end, (gap_m - height_m(end)) * normal);
  }
  moves.apply(positions);
}

}  // namespace ribbon

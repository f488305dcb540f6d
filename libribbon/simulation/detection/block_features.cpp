#include "simulation/detection/block_features.h"

#include <algorithm>

namespace ribbon {

namespace {

template <std::size_t n>
BoxedFeature<n> boxed(const std::array<int, n>& vertices, std::span<const PackedBox> boxes) {
  BoxedFeature<n> feature{vertices, boxes[vertices[0]]};
  for (std::size_t k = 1; k < n; ++k) feature.box.include(boxes[vertices[k]]);
  return feature;
}

template <std::size_t n, std::size_t m>
bool share(const std::array<int, n>& some, const std::array<int, m>& others) {
  return std::any_of(some.begin(), some.end(), [&](int vertex) {
    return std::find(others.begin(), others.end(), vertex) != others.end();
  });
}

void list(const BoxedFeature<1>& vertex, const BoxedFeature<3>& triangle,
          std::vector<FeaturePair>& found) {
  const auto& t = triangle.vertices;
  if (vertex.box.meets(triangle.box) && !share(vertex.vertices, t))
    found.push_back({FeaturePair::Kind::vertex_triangle, {vertex.vertices[0], t[0], t[1], t[2]}});
}

void list(const BoxedFeature<2>& a, const BoxedFeature<2>& b, std::vector<FeaturePair>& found) {
  if (a.box.meets(b.box) && !share(a.vertices, b.vertices))
    found.push_back({FeaturePair::Kind::edge_edge,
                     {a.vertices[0], a.vertices[1], b.vertices[0], b.vertices[1]}});
}

// All of some features, and the box around them, against all of others.
template <std::size_t n, std::size_t m>
void list_all(std::span<const BoxedFeature<n>> some, const PackedBox& around,
              std::span<const BoxedFeature<m>> others, std::vector<FeaturePair>& found) {
  for (const BoxedFeature<m>& other : others)
    if (other.box.meets(around))
      for (const BoxedFeature<n>& one : some) list(one, other, found);
}

}  // namespace

BlockFeatures::BlockFeatures(const RibbonGrid& grid, int row, int column,
                             std::span<const PackedBox> boxes)
    : box_(boxes[grid.particle(block_side * row, block_side * column)]) {
  const int end_row = std::min(block_side * (row + 1), grid.along - 1);
  const int end_column = std::min(block_side * (column + 1), grid.across - 1);
  // The last particles belong to the next block, if there is one.
  const auto has_row = [&](int i) { return i < end_row || end_row == grid.along - 1; };
  const auto has_column = [&](int j) { return j < end_column || end_column == grid.across - 1; };
  for (int i = block_side * row; i <= end_row; ++i)
    for (int j = block_side * column; j <= end_column; ++j) {
      const int here = grid.particle(i, j);
      box_.include(boxes[here]);
      if (has_row(i) && has_column(j)) vertices_.add(boxed<1>({here}, boxes));
      if (i < end_row && has_column(j)) edges_.add(boxed<2>({here, here + grid.across}, boxes));
      if (j < end_column && has_row(i)) edges_.add(boxed<2>({here, here + 1}, boxes));
      if (i < end_row && j < end_column) add_quad(grid, i, j, boxes);
    }
}

void BlockFeatures::add_quad(const RibbonGrid& grid, int row, int column,
                             std::span<const PackedBox> boxes) {
  const int quad = row * (grid.across - 1) + column;
  edges_.add(boxed(grid.diagonal(quad), boxes));
  for (const int triangle : {2 * quad, 2 * quad + 1})
    triangles_.add(boxed(grid.triangle(triangle), boxes));
}

void BlockFeatures::list_within(std::vector<FeaturePair>& found) const {
  for (const BoxedFeature<3>& triangle : triangles_.all())
    for (const BoxedFeature<1>& vertex : vertices_.all()) list(vertex, triangle, found);
  const auto edges = edges_.all();
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) list(edges[i], edges[j], found);
}

void BlockFeatures::list_between(const BlockFeatures& other,
                                 std::vector<FeaturePair>& found) const {
  list_all(vertices_.all(), box_, other.triangles_.all(), found);
  list_all(other.vertices_.all(), other.box_, triangles_.all(), found);
  list_all(edges_.all(), box_, other.edges_.all(), found);
}

void BlockFeatures::list_with(const CollisionSurface& obstacle, int first_vertex, int triangle,
                              const std::array<PackedBox, 3>& corners,
                              std::vector<FeaturePair>& found) const {
  const Eigen::Vector3i vertices = obstacle.triangles.col(triangle).array() + first_vertex;
  BoxedFeature<3> whole{{vertices[0], vertices[1], vertices[2]}, corners[0]};
  whole.box.include(corners[1]);
  whole.box.include(corners[2]);
  if (!whole.box.meets(box_)) return;
  for (const BoxedFeature<1>& vertex : vertices_.all()) list(vertex, whole, found);
  for (int c = 0; c < 3; ++c) {
    if (obstacle.answers_for_vertex(triangle, c))
      for (const BoxedFeature<3>& own : triangles_.all())
        list({{vertices[c]}, corners[c]}, own, found);
    if (!obstacle.answers_for_edge(triangle, c)) continue;
    const auto [a, b] = obstacle.edges[obstacle.triangle_edges[triangle][c]];
    BoxedFeature<2> theirs{{first_vertex + a, first_vertex + b}, corners[c]};
    theirs.box.include(corners[(c + 1) % 3]);
    for (const BoxedFeature<2>& own : edges_.all()) list(own, theirs, found);
  }
}

}  // namespace ribbon

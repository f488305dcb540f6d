#include "simulation/detection/block_features.h"

#include <algorithm>

namespace ribbon {

namespace {

template <std::size_t n, std::size_t m>
bool share(const std::array<int, n>& some, const std::array<int, m>& others) {
  bool any = false;
  for (const int vertex : some)
    for (const int other : others) any = any || vertex == other;
  return any;
}

FeaturePair pair_of(const BoxedFeature<1>& vertex, const BoxedFeature<3>& triangle) {
  const auto& t = triangle.vertices;
  return {FeaturePair::Kind::vertex_triangle, {vertex.vertices[0], t[0], t[1], t[2]}};
}

FeaturePair pair_of(const BoxedFeature<2>& a, const BoxedFeature<2>& b) {
  return {FeaturePair::Kind::edge_edge,
          {a.vertices[0], a.vertices[1], b.vertices[0], b.vertices[1]}};
}

template <std::size_t n, std::size_t m>
void list(const BoxedFeature<n>& one, const BoxedFeature<m>& other,
          std::vector<FeaturePair>& found) {
  if ((one.is_looked_at || other.is_looked_at) && one.box.meets(other.box) &&
      !share(one.vertices, other.vertices))
    found.push_back(pair_of(one, other));
}

// Those of some features whose boxes meet another box, in order.
template <std::size_t n>
class Near {
 public:
  Near(std::span<const BoxedFeature<n>> features, const PackedBox& box) {
    for (const BoxedFeature<n>& feature : features) {
      features_[count_] = &feature;
      count_ += feature.box.meets(box) ? 1 : 0;
    }
  }
  [[nodiscard]] std::span<const BoxedFeature<n>* const> all() const {
    return std::span(features_).first(count_);
  }
  // Around them: there must be some.
  [[nodiscard]] PackedBox box() const {
    PackedBox box = features_[0]->box;
    for (const BoxedFeature<n>* feature : all().subspan(1)) box.include(feature->box);
    return box;
  }

 private:
  // Edges are the most that a block has of a kind; one place more is written and not counted.
  std::array<const BoxedFeature<n>*, edges_of_block + 1> features_;
  std::size_t count_ = 0;
};

template <std::size_t n, std::size_t m>
void list_all(const Near<n>& some, const Near<m>& others, std::vector<FeaturePair>& found) {
  for (const BoxedFeature<m>* other : others.all())
    for (const BoxedFeature<n>* one : some.all()) list(*one, *other, found);
}

}  // namespace

ObstacleTriangle::ObstacleTriangle(const CollisionSurface& surface, int first_vertex, int triangle,
                                   const std::array<PackedBox, 3>& corners) {
  const auto number = [&](int vertex) { return first_vertex + vertex; };
  for (int c = 0; c < 3; ++c) {
    vertices[c] = {{number(surface.triangles(c, triangle))}, false, corners[c]};
    const auto [a, b] = surface.edges[surface.triangle_edges[triangle][c]];
    edges[c] = {{number(a), number(b)}, false, corners[c]};
    edges[c].box.include(corners[(c + 1) % 3]);
    answers_for_vertex[c] = surface.answers_for_vertex(triangle, c);
    answers_for_edge[c] = surface.answers_for_edge(triangle, c);
  }
  whole = {{vertices[0].vertices[0], vertices[1].vertices[0], vertices[2].vertices[0]},
           false,
           edges[0].box};
  whole.box.include(corners[2]);
}

BlockShape::BlockShape(const RibbonGrid& grid, int row, int column) {
  const int first = grid.particle(block_side * row, block_side * column);
  const auto add = [&](auto of_grid, auto& list) {
    for (int& vertex : of_grid) vertex -= first;
    list.add() = of_grid;
  };
  const int end_row = std::min(block_side * (row + 1), grid.along - 1);
  const int end_column = std::min(block_side * (column + 1), grid.across - 1);
  // The last particles belong to the next block, if there is one.
  const auto has_row = [&](int i) { return i < end_row || end_row == grid.along - 1; };
  const auto has_column = [&](int j) { return j < end_column || end_column == grid.across - 1; };
  for (int i = block_side * row; i <= end_row; ++i)
    for (int j = block_side * column; j <= end_column; ++j) {
      const int here = grid.particle(i, j);
      add(std::array{here}, particles);
      if (has_row(i) && has_column(j)) add(std::array{here}, vertices);
      if (i < end_row && has_column(j)) add(std::array{here, here + grid.across}, edges);
      if (j < end_column && has_row(i)) add(std::array{here, here + 1}, edges);
      if (i == end_row || j == end_column) continue;
      add(grid.diagonal(i, j), edges);
      for (const auto& triangle : grid.halves(i, j)) add(triangle, triangles);
    }
}

BlockFeatures::BlockFeatures(const BlockShape& shape, int first_particle,
                             std::span<const PackedBox> boxes, std::span<const char> is_looked_at)
    : box_(boxes[first_particle]) {
  for (const auto& [offset] : shape.particles.all()) box_.include(boxes[first_particle + offset]);
  const auto add_all = [&]<std::size_t n>(std::span<const std::array<int, n>> of_shape,
                                          auto& features) {
    for (const std::array<int, n>& offsets : of_shape) {
      BoxedFeature<n>& feature = features.add();
      const int first = first_particle + offsets[0];
      feature.vertices[0] = first;
      bool looked_at = is_looked_at[first] != 0;
      PackedBox box = boxes[first];
      for (std::size_t k = 1; k < n; ++k) {
        const int vertex = first_particle + offsets[k];
        feature.vertices[k] = vertex;
        looked_at = is_looked_at[vertex] != 0 || looked_at;
        box.include(boxes[vertex]);
      }
      feature.is_looked_at = looked_at;
      feature.box = box;
    }
  };
  add_all(shape.vertices.all(), vertices_);
  add_all(shape.edges.all(), edges_);
  add_all(shape.triangles.all(), triangles_);
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
  // All features lie in the triangles: what comes close is in those that do, mostly few or none.
  const Near own(triangles_.all(), other.box_);
  if (own.all().empty()) return;
  const PackedBox near = own.box();
  const Near theirs(other.triangles_.all(), near);
  if (theirs.all().empty()) return;
  const PackedBox near_theirs = theirs.box();
  list_all(Near(vertices_.all(), near_theirs), theirs, found);
  list_all(Near(other.vertices_.all(), near), own, found);
  list_all(Near(edges_.all(), near_theirs), Near(other.edges_.all(), near), found);
}

void BlockFeatures::list_with(const ObstacleTriangle& of_obstacle,
                              std::vector<FeaturePair>& found) const {
  const PackedBox& whole = of_obstacle.whole.box;
  if (!whole.meets(box_)) return;
  for (const BoxedFeature<1>& vertex : vertices_.all()) list(vertex, of_obstacle.whole, found);
  const Near triangles(triangles_.all(), whole);
  const Near edges(edges_.all(), whole);
  for (int c = 0; c < 3; ++c) {
    if (of_obstacle.answers_for_vertex[c])
      for (const BoxedFeature<3>* own : triangles.all()) list(of_obstacle.vertices[c], *own, found);
    if (of_obstacle.answers_for_edge[c])
      for (const BoxedFeature<2>* own : edges.all()) list(*own, of_obstacle.edges[c], found);
  }
}

}  // namespace ribbon

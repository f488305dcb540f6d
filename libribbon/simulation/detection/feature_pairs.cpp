#include "simulation/detection/feature_pairs.h"

#include "parallel/parallel.h"

namespace ribbon {

namespace {

// A triangle with the boxes of its features.
struct BoxedTriangle {
  BoxedTriangle(const RangedSurface& of, int number)
      : on(of.surface), first_vertex(of.first_vertex), triangle(number) {
    for (int c = 0; c < 3; ++c) {
      const int vertex = of.surface.triangles(c, number);
      vertices[c] = of.first_vertex + vertex;
      corners[c] = of.ranges[vertex];
      edges[c] = corners[c];
    }
    for (int c = 0; c < 3; ++c) edges[c].include(corners[(c + 1) % 3]);
    whole = edges[0];
    whole.include(corners[2]);
  }

  [[nodiscard]] bool has(int vertex) const {
    return vertex == vertices[0] || vertex == vertices[1] || vertex == vertices[2];
  }
  void grow(double margin_m) {
    for (MovingBox& box : corners) box.grow(margin_m);
    for (MovingBox& box : edges) box.grow(margin_m);
  }

  const CollisionSurface& on;
  int first_vertex;
  int triangle;
  std::array<int, 3> vertices{};
  std::array<MovingBox, 3> corners;
  std::array<MovingBox, 3> edges;  // edge c joins corners c and c+1
  MovingBox whole;
};

void list_vertices(const BoxedTriangle& of, const BoxedTriangle& against,
                   std::vector<FeaturePair>& found) {
  const auto& t = against.vertices;
  for (int c = 0; c < 3; ++c) {
    const int vertex = of.vertices[c];
    if (of.on.answers_for_vertex(of.triangle, c) && !against.has(vertex) &&
        of.corners[c].meets(against.whole))
      found.push_back({FeaturePair::Kind::vertex_triangle, {vertex, t[0], t[1], t[2]}});
  }
}

std::array<int, 2> edge_of(const BoxedTriangle& triangle, int corner) {
  const auto [a, b] = triangle.on.edges[triangle.on.triangle_edges[triangle.triangle][corner]];
  return {triangle.first_vertex + a, triangle.first_vertex + b};
}

// Lists the pairs of features of two triangles that neighbouring triangle pairs do not list as
// well.
void list_features(const RangedSurface& on_a, const RangedSurface& on_b, const CandidatePair& pair,
                   double margin_m, std::vector<FeaturePair>& found) {
  BoxedTriangle a(on_a, pair.a);
  BoxedTriangle b(on_b, pair.b);
  a.whole.grow(margin_m);
  if (!a.whole.meets(b.whole)) return;
  // Only one of two partners carries the margin, so it is grown by the whole of it.
  a.grow(margin_m);
  list_vertices(a, b, found);
  list_vertices(b, a, found);
  for (int i = 0; i < 3; ++i) {
    if (!a.on.answers_for_edge(a.triangle, i)) continue;
    for (int j = 0; j < 3; ++j) {
      if (!b.on.answers_for_edge(b.triangle, j)) continue;
      const auto e = edge_of(a, i);
      const auto f = edge_of(b, j);
      if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) continue;
      if (a.edges[i].meets(b.edges[j]))
        found.push_back({FeaturePair::Kind::edge_edge, {e[0], e[1], f[0], f[1]}});
    }
  }
}

}  // namespace

std::vector<FeaturePair> feature_pairs(const RangedSurface& a, const RangedSurface& b,
                                       std::span<const CandidatePair> pairs, double margin_m) {
  constexpr std::size_t grain = 256;
  std::vector<std::vector<FeaturePair>> found((pairs.size() + grain - 1) / grain);
  parallel_ranges(pairs.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      list_features(a, b, pairs[i], margin_m, found[begin / grain]);
  });
  std::vector<FeaturePair> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace ribbon

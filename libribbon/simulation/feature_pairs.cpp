#include "simulation/feature_pairs.h"

#include <algorithm>

#include "parallel/parallel.h"

namespace ribbon {

namespace {

// Lists the pairs of features of two triangles that neighbouring triangle pairs do not list as
// well.
class PairLister {
 public:
  PairLister(const CollisionSurface& a, const CollisionSurface& b, std::span<const Box> ranges,
             double margin_m)
      : a_(a), b_(b), ranges_(ranges), margin_m_(margin_m) {}

  void list(const TrianglePair& pair, std::vector<FeaturePair>& found) const {
    const Box box_a = box(a_, pair.a);
    const Box box_b = box(b_, pair.b);
    for (int corner = 0; corner < 3; ++corner) {
      if (a_.answers_for_vertex(pair.a, corner))
        list_vertex(a_.triangles(corner, pair.a), b_, pair.b, box_b, found);
      if (b_.answers_for_vertex(pair.b, corner))
        list_vertex(b_.triangles(corner, pair.b), a_, pair.a, box_a, found);
    }
    for (int i = 0; i < 3; ++i) {
      if (!a_.answers_for_edge(pair.a, i)) continue;
      for (int j = 0; j < 3; ++j)
        if (b_.answers_for_edge(pair.b, j))
          list_edges(edge(a_, pair.a, i), edge(b_, pair.b, j), found);
    }
  }

 private:
  using Edge = std::array<int, 2>;

  static Edge edge(const CollisionSurface& surface, int triangle, int corner) {
    return {surface.triangles(corner, triangle), surface.triangles((corner + 1) % 3, triangle)};
  }

  // Only one of the two partners carries the margin, so it is grown by the whole of it.
  [[nodiscard]] Box grown(Box box) const {
    box.grow(margin_m_);
    return box;
  }
  [[nodiscard]] const Box& box(int vertex) const {
    return ranges_[static_cast<std::size_t>(vertex)];
  }
  [[nodiscard]] Box box(const Edge& edge) const {
    Box result = box(edge[0]);
    result.include(box(edge[1]));
    return result;
  }
  [[nodiscard]] Box box(const CollisionSurface& surface, int triangle) const {
    Box result = box(surface.triangles(0, triangle));
    result.include(box(surface.triangles(1, triangle)));
    result.include(box(surface.triangles(2, triangle)));
    return result;
  }

  void list_vertex(int vertex, const CollisionSurface& surface, int triangle,
                   const Box& triangle_box, std::vector<FeaturePair>& found) const {
    const Eigen::Vector3i corners = surface.triangles.col(triangle);
    if (vertex == corners[0] || vertex == corners[1] || vertex == corners[2]) return;
    if (!grown(box(vertex)).meets(triangle_box)) return;
    found.push_back(
        {FeaturePair::Kind::vertex_triangle, {vertex, corners[0], corners[1], corners[2]}});
  }

  void list_edges(const Edge& e, const Edge& f, std::vector<FeaturePair>& found) const {
    if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) return;
    if (!grown(box(e)).meets(box(f))) return;
    found.push_back({FeaturePair::Kind::edge_edge, {e[0], e[1], f[0], f[1]}});
  }

  const CollisionSurface& a_;
  const CollisionSurface& b_;
  std::span<const Box> ranges_;
  double margin_m_;
};

}  // namespace

std::vector<FeaturePair> feature_pairs(const CollisionSurface& a, const CollisionSurface& b,
                                       std::span<const TrianglePair> pairs,
                                       std::span<const Box> ranges, double margin_m) {
  constexpr std::size_t grain = 256;
  const PairLister lister(a, b, ranges, margin_m);
  std::vector<std::vector<FeaturePair>> found((pairs.size() + grain - 1) / grain);
  parallel_ranges(pairs.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) lister.list(pairs[i], found[begin / grain]);
  });
  std::vector<FeaturePair> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace ribbon

#include "simulation/feature_pairs.h"

#include "parallel/parallel.h"

namespace ribbon {

namespace {

// Lists the pairs of features of two triangles that neighbouring triangle pairs do not list as
// well.
class PairLister {
 public:
  PairLister(const RangedSurface& a, const RangedSurface& b, double margin_m)
      : a_(a), b_(b), margin_m_(margin_m) {}

  void list(const CandidatePair& pair, std::vector<FeaturePair>& found) const {
    for (int corner = 0; corner < 3; ++corner) {
      if (a_.surface.answers_for_vertex(pair.a, corner))
        list_vertex(a_.surface.triangles(corner, pair.a), b_, pair.b, found);
      if (b_.surface.answers_for_vertex(pair.b, corner))
        list_vertex(b_.surface.triangles(corner, pair.b), a_, pair.a, found);
    }
    for (int i = 0; i < 3; ++i) {
      if (!a_.surface.answers_for_edge(pair.a, i)) continue;
      for (int j = 0; j < 3; ++j)
        if (b_.surface.answers_for_edge(pair.b, j))
          list_edges(edge_of(a_, pair.a, i), edge_of(b_, pair.b, j), found);
    }
  }

 private:
  static std::size_t edge_of(const RangedSurface& surface, int triangle, int corner) {
    return static_cast<std::size_t>(
        surface.surface
            .triangle_edges[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(corner)]);
  }

  // Only one of the two partners carries the margin, so it is grown by the whole of it.
  [[nodiscard]] MovingBox grown(MovingBox box) const {
    box.grow(margin_m_);
    return box;
  }

  void list_vertex(int vertex, const RangedSurface& other, int triangle,
                   std::vector<FeaturePair>& found) const {
    const Eigen::Vector3i corners = other.surface.triangles.col(triangle);
    if (vertex == corners[0] || vertex == corners[1] || vertex == corners[2]) return;
    const MovingBox& box = other.boxes.triangles[static_cast<std::size_t>(triangle)];
    if (!grown(other.ranges[static_cast<std::size_t>(vertex)]).meets(box)) return;
    found.push_back(
        {FeaturePair::Kind::vertex_triangle, {vertex, corners[0], corners[1], corners[2]}});
  }

  void list_edges(std::size_t edge_a, std::size_t edge_b, std::vector<FeaturePair>& found) const {
    const auto& e = a_.surface.edges[edge_a];
    const auto& f = b_.surface.edges[edge_b];
    if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) return;
    if (!grown(a_.boxes.edges[edge_a]).meets(b_.boxes.edges[edge_b])) return;
    found.push_back({FeaturePair::Kind::edge_edge, {e[0], e[1], f[0], f[1]}});
  }

  RangedSurface a_;
  RangedSurface b_;
  double margin_m_;
};

}  // namespace

std::vector<FeaturePair> feature_pairs(const RangedSurface& a, const RangedSurface& b,
                                       std::span<const CandidatePair> pairs, double margin_m) {
  constexpr std::size_t grain = 256;
  const PairLister lister(a, b, margin_m);
  std::vector<std::vector<FeaturePair>> found((pairs.size() + grain - 1) / grain);
  parallel_ranges(pairs.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) lister.list(pairs[i], found[begin / grain]);
  });
  std::vector<FeaturePair> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace ribbon

#include "simulation/detection/triangle_bvh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometry/vectors.h"
#include "simulation/detection/bvh_walk.h"
#include "simulation/detection/vertex_ranges.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// --- Building: groups of three neighbours with the shortest common contour -----------------------

struct Neighbour {
  int region = 0;
  double shared_m = 0;  // length of the shared outline
};

// The regions of one level while the next is grouped.
struct Level {
  std::vector<int> nodes;             // their node numbers
  std::vector<double> contours_m;     // length of each region's outline
  std::vector<int> first;             // into neighbours, one more than regions
  std::vector<Neighbour> neighbours;  // of all regions one after the other, by number in each

  [[nodiscard]] std::span<const Neighbour> neighbours_of(int region) const {
    const int begin = first[region];
    const int end = first[region + 1];
    return std::span(neighbours).subspan(begin, end - begin);
  }
};

// A piece of outline that `region` shares with `other`.
struct SharedPiece {
  int region = 0;
  int other = 0;
  double length_m = 0;
};

// Joins the pieces that two regions share.
void set_neighbours(std::vector<SharedPiece> pieces, Level& level) {
  std::stable_sort(pieces.begin(), pieces.end(), [](const SharedPiece& a, const SharedPiece& b) {
    return std::tie(a.region, a.other) < std::tie(b.region, b.other);
  });
  level.first.assign(level.contours_m.size() + 1, 0);
  const SharedPiece* last = nullptr;
  for (const SharedPiece& piece : pieces) {
    if (last == nullptr || last->region != piece.region || last->other != piece.other) {
      level.neighbours.push_back({piece.other, 0});
      ++level.first[piece.region + 1];
    }
    level.neighbours.back().shared_m += piece.length_m;
    last = &piece;
  }
  std::partial_sum(level.first.begin(), level.first.end(), level.first.begin());
}

double shared_m(const Level& level, int a, int b) {
  const auto neighbours = level.neighbours_of(a);
  const auto found = std::partition_point(neighbours.begin(), neighbours.end(),
                                          [&](const Neighbour& n) { return n.region < b; });
  return found == neighbours.end() || found->region != b ? 0 : found->shared_m;
}

// The triangles at each edge, one edge after the other, in order.
struct TrianglesAtEdges {
  explicit TrianglesAtEdges(const CollisionSurface& surface) : first(surface.edges.size() + 1, 0) {
    for (const auto& edges : surface.triangle_edges)
      for (const int edge : edges) ++first[edge + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    triangles.resize(first.back());
    std::vector<int> next = first;
    for (std::size_t t = 0; t < surface.triangle_edges.size(); ++t)
      for (const int edge : surface.triangle_edges[t])
        triangles[next[edge]++] = static_cast<int>(t);
  }

  [[nodiscard]] std::span<const int> at(std::size_t edge) const {
    return std::span(triangles).subspan(first[edge], first[edge + 1] - first[edge]);
  }

  std::vector<int> first;
  std::vector<int> triangles;
};

// Of the triangles at an edge each is a neighbour of so many before it and after it: of all, where
// they are eight or fewer. Of thousands, as the pages of a book, all pairs would fill the memory,
// and grouping them would take hours.
constexpr std::size_t most_after = 7;

Level triangle_level(const CollisionSurface& surface, const Matrix3Xd& positions) {
  Level level;
  const auto count = surface.triangles.cols();
  level.contours_m.assign(count, 0);
  level.nodes.resize(count);
  std::iota(level.nodes.begin(), level.nodes.end(), 0);
  const TrianglesAtEdges triangles(surface);
  std::vector<SharedPiece> pieces;
  for (std::size_t e = 0; e < surface.edges.size(); ++e) {
    const auto [a, b] = surface.edges[e];
    const double length_m = length_of(positions.col(b) - positions.col(a));
    const std::span<const int> meeting = triangles.at(e);
    for (std::size_t i = 0; i < meeting.size(); ++i) {
      const int t = meeting[i];
      level.contours_m[t] += length_m;
      const std::span<const int> after = meeting.subspan(i + 1);
      for (const int other : after.first(std::min(after.size(), most_after)))
        if (other != t) pieces.insert(pieces.end(), {{t, other, length_m}, {other, t, length_m}});
    }
  }
  set_neighbours(std::move(pieces), level);
  return level;
}

// The best partners for region r among the regions that are still free: none, one or two.
std::vector<int> best_partners(const Level& level, const std::vector<int>& group_of, int r) {
  const auto is_free = [&](int region) { return group_of[region] < 0; };
  const auto contour_m = [&](int region) { return level.contours_m[region]; };
  std::vector<int> best;
  double best_m = std::numeric_limits<double>::infinity();
  for (const auto& [a, ra_m] : level.neighbours_of(r)) {
    if (!is_free(a)) continue;
    const double pair_m = contour_m(r) + contour_m(a) - 2 * ra_m;
    if (best.size() < 2 && pair_m < best_m) {
      best = {a};
      best_m = pair_m;
    }
    for (const int middle : {r, a}) {
      for (const auto& [b, shared] : level.neighbours_of(middle)) {
        if (b == r || b == a || !is_free(b)) continue;
        const double triple_m =
            pair_m + contour_m(b) - 2 * (shared_m(level, r, b) + shared_m(level, a, b));
        if (best.size() < 2 || triple_m < best_m) {
          best = {a, b};
          best_m = triple_m;
        }
      }
    }
  }
  return best;
}

// Numbers of the groups that the regions of `level` form; returns how many there are: as many as
// regions when no two of them are connected.
int grouped(const Level& level, std::vector<int>& group_of) {
  const auto count = static_cast<int>(level.nodes.size());
  group_of.assign(level.nodes.size(), -1);
  int groups = 0;
  for (int r = 0; r < count; ++r) {
    if (group_of[r] >= 0) continue;
    const std::vector<int> partners = best_partners(level, group_of, r);
    if (partners.empty()) {
      // All neighbours are taken: join the one with the longest shared outline.
      int best = -1;
      double best_m = -1;
      for (const auto& [a, shared] : level.neighbours_of(r))
        if (shared > best_m) {
          best = a;
          best_m = shared;
        }
      if (best >= 0) {
        group_of[r] = group_of[best];
        continue;
      }
    }
    group_of[r] = groups;
    for (const int partner : partners) group_of[partner] = groups;
    ++groups;
  }
  return groups;
}

Level next_level(const Level& level, const std::vector<int>& group_of, int groups) {
  Level next;
  next.contours_m.assign(groups, 0);
  std::vector<SharedPiece> pieces;
  for (std::size_t r = 0; r < level.nodes.size(); ++r) {
    const int group = group_of[r];
    next.contours_m[group] += level.contours_m[r];
    for (const auto& [other, shared] : level.neighbours_of(static_cast<int>(r))) {
      const int other_group = group_of[other];
      if (other_group == group_of[r])
        next.contours_m[group] -= shared;
      else
        pieces.push_back({group_of[r], other_group, shared});
    }
  }
  set_neighbours(std::move(pieces), next);
  return next;
}

// --- Borders -------------------------------------------------------------------------------------

// How many triangles of a region use a vertex of its border.
struct Use {
  int vertex = 0;
  int count = 0;
};

// One for each vertex, in order, with the counts added up.
void join(std::vector<Use>& uses) {
  std::sort(uses.begin(), uses.end(),
            [](const Use& a, const Use& b) { return a.vertex < b.vertex; });
  std::size_t joined = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (joined > 0 && uses[joined - 1].vertex == uses[i].vertex)
      uses[joined - 1].count += uses[i].count;
    else
      uses[joined++] = uses[i];
  }
  uses.resize(joined);
}

// --- Curvature -----------------------------------------------------------------------------------

// One bit for each of the 14 directions of a cube's faces and corners: does the normal point that
// way? A degenerate triangle points nowhere.
std::uint32_t directions_of(const Vector3d& n) {
  std::uint32_t bits = 0;
  const std::array<double, 7> along = {n[0],
                                       n[1],
                                       n[2],
                                       n[0] + n[1] + n[2],
                                       n[0] + n[1] - n[2],
                                       n[0] - n[1] + n[2],
                                       n[0] - n[1] - n[2]};
  for (unsigned d = 0; d < along.size(); ++d) {
    if (along[d] > 0) bits |= 1U << (2 * d);
    if (along[d] < 0) bits |= 2U << (2 * d);
  }
  return bits;
}

Vector3d normal(const Matrix3Xd& positions, const Eigen::Vector3i& triangle) {
  const Vector3d a = positions.col(triangle[0]);
  return (positions.col(triangle[1]) - a).cross(positions.col(triangle[2]) - a);
}

}  // namespace

TriangleBvh::TriangleBvh(const CollisionSurface& surface, const Matrix3Xd& positions)
    : triangles_(surface.triangles) {
  assert(triangles_.cols() > 0);
  Level level = triangle_level(surface, positions);
  first_child_.assign(level.nodes.size() + 1, 0);
  first_joining_node_ = std::numeric_limits<int>::max();
  std::vector<int> group_of;
  while (level.nodes.size() > 1) {
    int groups = grouped(level, group_of);
    if (groups == static_cast<int>(level.nodes.size())) {
      // Neighbourhood says nothing about separate pieces: they are paired as they come.
      first_joining_node_ =
          std::min(first_joining_node_, static_cast<int>(first_child_.size()) - 1);
      groups = (groups + 1) / 2;
      for (std::size_t r = 0; r < group_of.size(); ++r) group_of[r] = static_cast<int>(r / 2);
    }
    std::vector<std::vector<int>> members(groups);
    for (std::size_t r = 0; r < level.nodes.size(); ++r)
      members[group_of[r]].push_back(level.nodes[r]);
    Level next = next_level(level, group_of, groups);
    for (const auto& children : members) {
      next.nodes.push_back(static_cast<int>(first_child_.size()) - 1);
      children_.insert(children_.end(), children.begin(), children.end());
      first_child_.push_back(static_cast<int>(children_.size()));
    }
    level = std::move(next);
  }
  const std::size_t nodes = first_child_.size() - 1;
  boxes_.resize(nodes);

  measure_borders(positions.cols());
  refit(vertex_ranges(positions, positions), 0);
}

// A vertex lies on a region's border while a triangle outside the region uses it.
void TriangleBvh::measure_borders(std::size_t vertices) {
  std::vector<int> uses(vertices, 0);
  for (const int vertex : triangles_.reshaped()) ++uses[vertex];
  std::vector<int> counts;  // of what is in border_: how many triangles of the region use it
  std::vector<Use> within;
  first_border_.push_back(0);
  for (int node = 0; node < node_count(); ++node) {
    within.clear();
    if (is_leaf(node)) {
      for (const int vertex : triangles_.col(node)) within.push_back({vertex, 1});
    } else {
      for (const int child : children(node))
        for (int i = first_border_[child]; i < first_border_[child + 1]; ++i)
          within.push_back({border_[i], counts[i]});
    }
    join(within);
    for (const Use& use : within) {
      if (use.count == uses[use.vertex]) continue;
      border_.push_back(use.vertex);
      counts.push_back(use.count);
    }
    first_border_.push_back(static_cast<int>(border_.size()));
  }
  border_.shrink_to_fit();
}

// Bottom-up: each inner node joins its children.
template <class Node, class Join>
void TriangleBvh::refit_inner(std::vector<Node>& nodes, const Join& join) const {
  for (auto node = static_cast<std::size_t>(triangles_.cols()); node < nodes.size(); ++node) {
    const int first = first_child_[node];
    const int last = first_child_[node + 1];
    Node joined = nodes[children_[first]];
    for (int c = first + 1; c < last; ++c) join(joined, nodes[children_[c]]);
    nodes[node] = joined;
  }
}

void TriangleBvh::refit(std::span<const MovingBox> ranges, double margin_m) {
  for (Eigen::Index leaf = 0; leaf < triangles_.cols(); ++leaf) {
    const Eigen::Vector3i triangle = triangles_.col(leaf);
    MovingBox box = ranges[triangle[0]];
    box.include(ranges[triangle[1]]);
    box.include(ranges[triangle[2]]);
    box.grow(margin_m);
    boxes_[leaf] = box;
  }
  refit_inner(boxes_, [](MovingBox& box, const MovingBox& child) { box.include(child); });
  curvatures_.clear();
}

void TriangleBvh::refit_curvatures(const Matrix3Xd& t0, const Matrix3Xd& t1) {
  curvatures_.resize(boxes_.size());
  for (Eigen::Index leaf = 0; leaf < triangles_.cols(); ++leaf) {
    const Eigen::Vector3i triangle = triangles_.col(leaf);
    curvatures_[leaf] = directions_of(normal(t0, triangle)) & directions_of(normal(t1, triangle));
  }
  refit_inner(curvatures_, [](std::uint32_t& bits, std::uint32_t child) { bits &= child; });
  // Pieces that nothing connects: flat each, and yet they can meet.
  for (auto node = static_cast<std::size_t>(first_joining_node_); node < curvatures_.size(); ++node)
    curvatures_[node] = 0;
}

bool TriangleBvh::adjacent(int a, int b) const {
  const auto border = [&](int node) {
    return std::pair{border_.begin() + first_border_[node],
                     border_.begin() + first_border_[node + 1]};
  };
  auto [i, i_end] = border(a);
  auto [j, j_end] = border(b);
  while (i != i_end && j != j_end) {
    if (*i == *j) return true;
    *i < *j ? ++i : ++j;
  }
  return false;
}

bool TriangleBvh::can_meet(const NodePair& pair, Spare spare) const {
  assert(spare == Spare::boxes || curvatures_.size() == boxes_.size());
  const bool by_curvature =
      spare == Spare::curvature_and_boxes && (curvatures_[pair.a] & curvatures_[pair.b]) != 0;
  if (pair.a == pair.b) return !by_curvature && !is_leaf(pair.a);
  if (!boxes_[pair.a].meets(boxes_[pair.b])) return false;
  return !by_curvature || !adjacent(pair.a, pair.b);
}

void TriangleBvh::descend(const NodePair& pair, std::vector<NodePair>& next) const {
  if (pair.a != pair.b) {
    descend(*this, *this, pair, next);
    return;
  }
  const int first = first_child_[pair.a];
  const int last = first_child_[pair.a + 1];
  for (int i = first; i < last; ++i)
    for (int j = i; j < last; ++j) next.push_back({children_[i], children_[j]});
}

void TriangleBvh::descend(const TriangleBvh& first, const TriangleBvh& second, const NodePair& pair,
                          std::vector<NodePair>& next) {
  const auto size = [](const TriangleBvh& tree, int node) {
    const MovingBox& box = tree.boxes_[node];
    return squared_length_of(box.start.high - box.start.low + box.end.high - box.end.low);
  };
  const bool split_first = second.is_leaf(pair.b) ||
                           (!first.is_leaf(pair.a) && size(first, pair.a) >= size(second, pair.b));
  const TriangleBvh& tree = split_first ? first : second;
  const int node = split_first ? pair.a : pair.b;
  for (int c = tree.first_child_[node]; c < tree.first_child_[node + 1]; ++c) {
    const int child = tree.children_[c];
    next.push_back(split_first ? NodePair{child, pair.b} : NodePair{pair.a, child});
  }
}

std::vector<CandidatePair> TriangleBvh::pairs_within(Spare spare) const {
  return BvhWalk<CandidatePair, NodePair>().from(
      {root(), root()}, [this, spare](const NodePair& pair, std::vector<NodePair>& next,
                                      std::vector<CandidatePair>& found) {
        if (!can_meet(pair, spare)) return;
        if (is_leaf(pair.a) && is_leaf(pair.b))
          found.push_back({pair.a, pair.b});
        else
          descend(pair, next);
      });
}

std::vector<CandidatePair> TriangleBvh::pairs_with(const TriangleBvh& other) const {
  return BvhWalk<CandidatePair, NodePair>().from(
      {root(), other.root()},
      [&](const NodePair& pair, std::vector<NodePair>& next, std::vector<CandidatePair>& found) {
        if (!boxes_[pair.a].meets(other.boxes_[pair.b])) return;
        if (is_leaf(pair.a) && other.is_leaf(pair.b))
          found.push_back({pair.a, pair.b});
        else
          descend(*this, other, pair, next);
      });
}

}  // namespace ribbon

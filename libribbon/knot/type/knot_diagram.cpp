#include "knot/type/knot_diagram.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <utility>

#include "knot/type/view_crossing.h"

namespace ribbon {
namespace {

using Index = std::size_t;

struct EdgeCrossing {
  Index other_edge = 0;
  int crossing = 0;
  bool over = false;
};

// The crossings on each edge, edge e going from vertex e to vertex e + 1.
struct CrossedEdges {
  std::vector<std::vector<EdgeCrossing>> on_edge;
  std::vector<int> signs;
};

// Do two edges with a common vertex overlap in this view?
bool folded(const LongCurve& curve, Index edge, const ProjectivePoint& view) {
  return orientation(curve[edge], curve[edge + 1], curve[edge + 2], view) == 0;
}

std::optional<CrossedEdges> crossed_edges(const LongCurve& curve, const ProjectivePoint& view) {
  const Index edges = curve.size() - 1;
  CrossedEdges result{std::vector<std::vector<EdgeCrossing>>(edges), {}};
  for (Index e = 0; e + 1 < edges; ++e) {
    if (folded(curve, e, view)) return {};
    for (Index f = e + 2; f < edges; ++f) {
      const ViewCrossing pair = view_crossing(curve[e], curve[e + 1], curve[f], curve[f + 1], view);
      if (pair.seen == ViewOfEdges::doubtful) return {};
      if (pair.seen == ViewOfEdges::apart) continue;
      const auto crossing = static_cast<int>(result.signs.size());
      result.signs.push_back(pair.sign);
      result.on_edge[e].push_back({f, crossing, pair.first_over});
      result.on_edge[f].push_back({e, crossing, !pair.first_over});
    }
  }
  return result;
}

// Puts the crossings of an edge in the order in which they are met. False if two coincide.
bool put_in_order(std::vector<EdgeCrossing>& crossings, const LongCurve& curve, Index edge,
                  const ProjectivePoint& view) {
  const auto order = [&](const EdgeCrossing& one, const EdgeCrossing& other) {
    return order_along(curve[edge], curve[edge + 1], curve[one.other_edge],
                       curve[one.other_edge + 1], curve[other.other_edge],
                       curve[other.other_edge + 1], view);
  };
  std::sort(crossings.begin(), crossings.end(),
            [&](const auto& one, const auto& other) { return order(one, other) < 0; });
  const auto coincide = [&](const auto& one, const auto& other) { return order(one, other) == 0; };
  return std::adjacent_find(crossings.begin(), crossings.end(), coincide) == crossings.end();
}

using Pass = KnotDiagram::Pass;

// The pass after pass k, and after the last one the first: the knot is closed far away.
Index after(const KnotDiagram& knot, Index k) {
  return k + 1 == knot.passes.size() ? 0 : k + 1;
}

Index before(const KnotDiagram& knot, Index k) {
  return k == 0 ? knot.passes.size() - 1 : k - 1;
}

// The crossing that is passed at both ends of a loop without crossings (first Reidemeister move).
std::optional<int> find_loop(const KnotDiagram& knot) {
  for (Index k = 0; k < knot.passes.size(); ++k)
    if (knot.passes[k].crossing == knot.passes[after(knot, k)].crossing)
      return knot.passes[k].crossing;
  return {};
}

std::vector<Index> passes_under(const KnotDiagram& knot) {
  std::vector<Index> result(knot.signs.size());
  for (Index k = 0; k < knot.passes.size(); ++k)
    if (!knot.passes[k].over) result[static_cast<Index>(knot.passes[k].crossing)] = k;
  return result;
}

// Two crossings at which one strand passes over another and comes back, with nothing in between on
// either (second Reidemeister move). If the knot goes on inside the loop of the two edges at one
// crossing and outside at the other, each crossing only turns a part of the knot over and can go
// too.
std::optional<std::pair<int, int>> find_bigon(const KnotDiagram& knot) {
  const std::vector<Index> under = passes_under(knot);
  for (Index k = 0; k < knot.passes.size(); ++k) {
    const Pass& first = knot.passes[k];
    const Pass& second = knot.passes[after(knot, k)];
    if (!first.over || !second.over) continue;
    const auto a = static_cast<Index>(first.crossing);
    const auto b = static_cast<Index>(second.crossing);
    const bool neighbours = after(knot, under[a]) == under[b] || after(knot, under[b]) == under[a];
    if (neighbours) return std::pair{first.crossing, second.crossing};
  }
  return {};
}

void remove(KnotDiagram& knot, int crossing) {
  std::erase_if(knot.passes, [&](const Pass& pass) { return pass.crossing == crossing; });
  for (Pass& pass : knot.passes) pass.crossing -= pass.crossing > crossing ? 1 : 0;
  knot.signs.erase(knot.signs.begin() + crossing);
}

// The ends of the pieces between passes: where the walk arrives at pass k, 2 k, and where it leaves
// it, 2 k + 1. Gives, for each, the next one counter-clockwise round its crossing.
std::vector<Index> next_counter_clockwise(const KnotDiagram& knot) {
  std::vector<Index> over(knot.signs.size());
  for (Index k = 0; k < knot.passes.size(); ++k)
    if (knot.passes[k].over) over[static_cast<Index>(knot.passes[k].crossing)] = k;
  const std::vector<Index> under = passes_under(knot);
  std::vector<Index> next(2 * knot.passes.size());
  for (Index i = 0; i < knot.signs.size(); ++i) {
    // A right-handed crossing's lower strand goes from the right of the upper one to its left.
    const Index from_left = knot.signs[i] > 0 ? 0 : 1;
    const Index left = 2 * under[i] + 1 - from_left;
    const Index right = 2 * under[i] + from_left;
    next[2 * over[i] + 1] = left;
    next[left] = 2 * over[i];
    next[2 * over[i]] = right;
    next[right] = 2 * over[i] + 1;
  }
  return next;
}

// The regions of the surface on which the closed knot can be drawn.
Index count_regions(const KnotDiagram& knot) {
  const std::vector<Index> next = next_counter_clockwise(knot);
  const auto other_end = [&](Index end) {
    return end % 2 == 1 ? 2 * after(knot, end / 2) : 2 * before(knot, end / 2) + 1;
  };
  std::vector<bool> seen(next.size(), false);
  Index regions = 0;
  for (Index start = 0; start < next.size(); ++start) {
    if (seen[start]) continue;
    ++regions;
    for (Index end = start; !seen[end]; end = next[other_end(end)]) seen[end] = true;
  }
  return regions;
}

}  // namespace

int KnotDiagram::writhe() const {
  return std::accumulate(signs.begin(), signs.end(), 0);
}

// By Euler's formula for a sphere.
bool is_planar(const KnotDiagram& diagram) {
  return diagram.passes.empty() || count_regions(diagram) == diagram.signs.size() + 2;
}

std::optional<KnotDiagram> diagram(const LongCurve& curve, const ProjectivePoint& view) {
  assert(view.is_direction);
  std::optional<CrossedEdges> edges = crossed_edges(curve, view);
  if (!edges) return {};
  KnotDiagram result{{}, std::move(edges->signs)};
  for (Index e = 0; e < edges->on_edge.size(); ++e) {
    if (!put_in_order(edges->on_edge[e], curve, e, view)) return {};
    for (const EdgeCrossing& crossing : edges->on_edge[e])
      result.passes.push_back({crossing.crossing, crossing.over});
  }
  return result;
}

KnotDiagram reduced(KnotDiagram diagram) {
  for (;;) {
    if (const auto loop = find_loop(diagram)) {
      remove(diagram, *loop);
    } else if (const auto bigon = find_bigon(diagram)) {
      remove(diagram, std::max(bigon->first, bigon->second));
      remove(diagram, std::min(bigon->first, bigon->second));
    } else {
      return diagram;
    }
  }
}

std::optional<KnotDiagram> simple_diagram(const LongCurve& curve) {
  // Directions with nothing in common but that they are written in few digits.
  static const std::array<Eigen::Vector3d, 9> views{{{0.04, -0.05, 1},
                                                     {-0.07, 1, 0.03},
                                                     {1, 0.06, -0.02},
                                                     {0.6, 0.5, 0.7},
                                                     {-0.7, 0.5, 0.6},
                                                     {0.6, -0.8, 0.5},
                                                     {-0.5, -0.6, 0.8},
                                                     {0.9, 0.3, -0.4},
                                                     {-0.2, 0.8, -0.5}}};
  std::optional<KnotDiagram> best;
  for (const Eigen::Vector3d& view : views) {
    std::optional<KnotDiagram> seen = diagram(curve, ProjectivePoint::direction(view));
    if (!seen) continue;
    KnotDiagram simple = reduced(*std::move(seen));
    if (!best || simple.crossing_count() < best->crossing_count()) best = std::move(simple);
  }
  return best;
}

}  // namespace ribbon

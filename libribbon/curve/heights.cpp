// Difference constraints as a graph: an edge from u to v of length w says that v lies at most w
// higher than u. The shortest way from the plane to a passage is then the highest place it can
// have, and a circle of negative length a contradiction.
#include "curve/heights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace ribbon {

namespace {

constexpr double room_for_rounding = 0.999;  // of the widest gap
constexpr int halvings = 20;                 // to find how far from the plane passages must be

// Node 0 is the plane, in which both ends lie; node i + 1 is passage i.
struct Edge {
  std::size_t from = 0;
  std::size_t to = 0;
  double length = 0;
  std::optional<std::size_t> way = std::nullopt;  // none: the edge of a crossing or a bound
  double share = 0;                               // of a crossing
};

Edge edge_of(const ObjectBound& bound, double gap) {
  return bound.in_front ? Edge{bound.passage + 1, 0, -bound.height - gap / 2}
                        : Edge{0, bound.passage + 1, bound.height - gap / 2};
}

std::vector<Edge> edges_of(const WalkProfile& profile, double gap) {
  std::vector<Edge> edges;
  const std::size_t nodes = profile.passage_count() + 1;
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::size_t next = (i + 1) % nodes;
    edges.push_back({i, next, profile.rises[i], i});
    edges.push_back({next, i, profile.rises[i], i});
  }
  for (const auto& [above, below, share] : profile.crossings)
    edges.push_back({above + 1, below + 1, -gap * share, std::nullopt, share});
  for (const ObjectBound& bound : profile.bounds) edges.push_back(edge_of(bound, gap));
  return edges;
}

// The edges of a circle that has been walked `nodes` edges back from somewhere.
std::vector<Edge> circle_before(std::size_t node, std::size_t nodes,
                                const std::vector<const Edge*>& last_edge) {
  for (std::size_t i = 0; i < nodes; ++i) node = last_edge[node]->from;
  std::vector<Edge> circle;
  for (std::size_t at = node; circle.empty() || at != node; at = last_edge[at]->from)
    circle.push_back(*last_edge[at]);
  std::reverse(circle.begin(), circle.end());
  return circle;
}

using Lengths = std::vector<double>;
using Circle = std::vector<Edge>;

// Bellman and Ford: from node 0 to each node, or a circle of negative length.
std::variant<Lengths, Circle> shortest_ways(const std::vector<Edge>& edges, std::size_t nodes) {
  Lengths lengths(nodes, std::numeric_limits<double>::infinity());
  lengths[0] = 0;
  std::vector<const Edge*> last_edge(nodes, nullptr);
  std::size_t shortened = 0;
  for (std::size_t round = 0; round <= nodes; ++round) {
    bool changed = false;
    for (const Edge& edge : edges) {
      if (lengths[edge.from] + edge.length >= lengths[edge.to]) continue;
      lengths[edge.to] = lengths[edge.from] + edge.length;
      last_edge[edge.to] = &edge;
      shortened = edge.to;
      changed = true;
    }
    if (!changed) return lengths;
  }
  return circle_before(shortened, nodes, last_edge);
}

// A crossing's edge leads from passage to passage, a bound's from the plane or to it.
void add_gap(const Edge& edge, double gap, TightCircle& tight) {
  if (edge.from != 0 && edge.to != 0) {
    tight.crossings += edge.share;
  } else {
    ++tight.bounds;
    tight.object -= edge.length + gap / 2;
  }
}

// Ways that follow one another are one stretch.
TightCircle tight_circle(Circle circle, const WalkProfile& profile, double gap) {
  const auto crossing =
      std::find_if(circle.begin(), circle.end(), [](const Edge& edge) { return !edge.way; });
  std::rotate(circle.begin(), crossing, circle.end());
  TightCircle tight;
  bool goes_on = false;
  for (const Edge& edge : circle) {
    if (!edge.way) {
      add_gap(edge, gap, tight);
    } else {
      const std::size_t way = *edge.way;
      const bool joins = goes_on && edge.from != 0;
      if (!joins) tight.stretches.push_back({way, way});
      Stretch& last = tight.stretches.back();
      last = {std::min(last.from, way), std::max(last.to, way)};
      tight.rise += profile.rises[way];
    }
    goes_on = edge.way.has_value();
  }
  return tight;
}

std::vector<double> two_levels(const WalkProfile& profile, double gap) {
  std::vector<double> heights(profile.passage_count());
  for (const auto& [above, below, share] : profile.crossings) {
    heights[above] = gap * share / 2;
    heights[below] = -gap * share / 2;
  }
  return heights;
}

bool rises_gently(const WalkProfile& profile, const std::vector<double>& heights) {
  double before = 0;
  for (std::size_t i = 0; i <= heights.size(); ++i) {
    const double here = i < heights.size() ? heights[i] : 0;
    if (std::abs(here - before) > profile.rises[i]) return false;
    before = here;
  }
  return true;
}

// In the middle between the highest and the lowest place that the edges leave each passage.
std::variant<std::vector<double>, Circle> middle_heights(std::vector<Edge> edges,
                                                         std::size_t nodes) {
  auto up = shortest_ways(edges, nodes);
  if (auto* circle = std::get_if<Circle>(&up)) return std::move(*circle);
  for (Edge& edge : edges) std::swap(edge.from, edge.to);
  const auto down = std::get<Lengths>(shortest_ways(edges, nodes));
  std::vector<double> heights;
  for (std::size_t i = 1; i < nodes; ++i)
    heights.push_back((std::get<Lengths>(up)[i] - down[i]) / 2);
  return heights;
}

// Likewise, none farther from the plane than `farthest`.
std::variant<std::vector<double>, Circle> middle_heights_within(double farthest,
                                                                std::vector<Edge> edges,
                                                                std::size_t nodes) {
  for (std::size_t i = 1; i < nodes; ++i) {
    edges.push_back({0, i, farthest});
    edges.push_back({i, 0, farthest});
  }
  return middle_heights(std::move(edges), nodes);
}

// There is a solution, so one within the farthest height of that.
std::vector<double> near_the_plane(std::vector<double> heights, const std::vector<Edge>& edges,
                                   std::size_t nodes) {
  double none_within = 0;
  double some_within = 0;
  for (const double height : heights) some_within = std::max(some_within, std::abs(height));
  for (int halving = 0; halving < halvings; ++halving) {
    const double farthest = (none_within + some_within) / 2;
    auto nearer = middle_heights_within(farthest, edges, nodes);
    if (auto* found = std::get_if<std::vector<double>>(&nearer)) heights = std::move(*found);
    (std::holds_alternative<Circle>(nearer) ? none_within : some_within) = farthest;
  }
  return heights;
}

std::variant<std::vector<double>, TightCircle> solved(const WalkProfile& profile, double gap) {
  const std::vector<Edge> edges = edges_of(profile, gap);
  const std::size_t nodes = profile.passage_count() + 1;
  auto heights = middle_heights(edges, nodes);
  if (auto* circle = std::get_if<Circle>(&heights))
    return tight_circle(std::move(*circle), profile, gap);
  auto found = std::get<std::vector<double>>(std::move(heights));
  return profile.bounds.empty() ? found : near_the_plane(std::move(found), edges, nodes);
}

}  // namespace

Heights passage_heights(const WalkProfile& profile, double gap) {
  Heights result{{}, gap};
  while (result.passages.size() < profile.passage_count() && result.gap > 0) {
    result.passages = two_levels(profile, result.gap);
    if (profile.bounds.empty() && rises_gently(profile, result.passages)) break;
    auto heights = solved(profile, result.gap);
    if (auto* tight = std::get_if<TightCircle>(&heights)) {
      result.passages.clear();
      result.gap = room_for_rounding * tight->gap();
      result.tight = std::move(*tight);
    } else {
      result.passages = std::get<std::vector<double>>(std::move(heights));
    }
  }
  return result;
}

}  // namespace ribbon

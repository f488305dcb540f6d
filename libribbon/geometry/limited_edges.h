// Which edges of a ribbon are kept near their rest length.
#pragma once

namespace ribbon {

struct LimitedEdges {
  bool along = false;
  bool across = false;
  bool diagonals = false;  // both of each quad

  [[nodiscard]] bool any() const { return along || across || diagonals; }

  bool operator==(const LimitedEdges&) const = default;
};

inline constexpr LimitedEdges all_edges{.along = true, .across = true, .diagonals = true};

// Those whose strain is told: all where none is limited.
inline LimitedEdges measured_edges(const LimitedEdges& limited) {
  return limited.any() ? limited : all_edges;
}

// Those that are limited by both.
inline LimitedEdges common(const LimitedEdges& a, const LimitedEdges& b) {
  return {a.along && b.along, a.across && b.across, a.diagonals && b.diagonals};
}

}  // namespace ribbon

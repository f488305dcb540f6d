#include "simulation/patch_tree.h"

#include <algorithm>
#include <cmath>

#include "parallel/parallel.h"
#include "simulation/tree_walk.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;

constexpr int surrounding_quads = 2;  // to every side of a patch

Vector3d middle(const Box& box) {
  return (box.low + box.high) / 2;
}

Vector3d half(const Box& box) {
  return (box.high - box.low) / 2;
}

MovingBox edge(const MovingBox& from, const MovingBox& to) {
  return {Box::around(middle(to.start) - middle(from.start)),
          Box::around(middle(to.end) - middle(from.end))};
}

// How far a particle may be beside its straight way.
double freedom_m(const MovingBox& range) {
  return half(range.end).norm();
}

// In the frame u, v: a lower bound of the smallest eigenvalue of the symmetric part of a matrix
// whose columns are an edge along over along_m and an edge across over across_m.
double least_stretch(const Box& along, double along_m, const Box& across, double across_m,
                     const Vector3d& u, const Vector3d& v) {
  const Vector3d a = middle(along) / along_m;
  const Vector3d c = middle(across) / across_m;
  const Vector3d a_spread = half(along) / along_m;
  const Vector3d c_spread = half(across) / across_m;
  const double p = a.dot(u) - a_spread.dot(u.cwiseAbs());
  const double s = c.dot(v) - c_spread.dot(v.cwiseAbs());
  const double q =
      (std::abs(a.dot(v) + c.dot(u)) + a_spread.dot(v.cwiseAbs()) + c_spread.dot(u.cwiseAbs())) / 2;
  return (p + s) / 2 - std::sqrt((p - s) * (p - s) / 4 + q * q);
}

}  // namespace

void PatchTree::Tangents::include(const Tangents& other) {
  along.include(other.along);
  across.include(other.across);
  freedom_m = std::max(freedom_m, other.freedom_m);
}

PatchTree::PatchTree(const RibbonGrid& grid) : grid_(grid) {
  build({.first_row = 0,
         .end_row = grid.along - 1,
         .first_column = 0,
         .end_column = grid.across - 1});
  boxes_.resize(patches_.size());
  tangents_.resize(patches_.size());
  flat_.resize(patches_.size());
  quads_.resize(static_cast<std::size_t>(grid.quad_count()));
  widened_.resize(quads_.size());
}

// Returns the patch's number. The longer side is halved.
int PatchTree::build(Patch patch) {
  if (patch.quads() > 1) {
    Patch first = patch;
    Patch second = patch;
    if (patch.end_row - patch.first_row >= patch.end_column - patch.first_column)
      first.end_row = second.first_row = (patch.first_row + patch.end_row) / 2;
    else
      first.end_column = second.first_column = (patch.first_column + patch.end_column) / 2;
    patch.first_child = build(first);
    patch.second_child = build(second);
  }
  patches_.push_back(patch);
  return root();
}

// The yardstick of flatness: any would do, this one lets most patches pass.
void PatchTree::measure_edges(std::span<const MovingBox> ranges) {
  const auto length_m = [&](int a, int b) {
    return (ranges[static_cast<std::size_t>(b)].start.low -
            ranges[static_cast<std::size_t>(a)].start.low)
        .norm();
  };
  double along_m = 0;
  double across_m = 0;
  for (int particle = 0; particle < grid_.particle_count(); ++particle) {
    if (grid_.row(particle) + 1 < grid_.along)
      along_m += length_m(particle, particle + grid_.across);
    if (grid_.column(particle) + 1 < grid_.across) across_m += length_m(particle, particle + 1);
  }
  along_m_ = along_m / (static_cast<double>(grid_.along - 1) * grid_.across);
  across_m_ = across_m / (static_cast<double>(grid_.across - 1) * grid_.along);
}

// Of every quad with what surrounds it: first beside it in its row, then over the rows.
void PatchTree::refit_quads(std::span<const MovingBox> ranges) {
  const int columns = grid_.across - 1;
  const int rows = grid_.along - 1;
  const auto quad = [columns](int row, int column) {
    return static_cast<std::size_t>(row * columns + column);
  };
  const auto for_rows = [rows](const auto& body) {
    parallel_ranges(static_cast<std::size_t>(rows), 32, [&](std::size_t begin, std::size_t end) {
      for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) body(row);
    });
  };
  for_rows([&](int row) {
    for (int column = 0; column < columns; ++column) {
      const auto corners = grid_.quad(row * columns + column);
      const auto range = [&](std::size_t k) -> const MovingBox& {
        return ranges[static_cast<std::size_t>(corners[k])];
      };
      Tangents& own = quads_[quad(row, column)];
      own.along = edge(range(0), range(1));
      own.along.include(edge(range(3), range(2)));
      own.across = edge(range(0), range(3));
      own.across.include(edge(range(1), range(2)));
      own.freedom_m = std::max(
          {freedom_m(range(0)), freedom_m(range(1)), freedom_m(range(2)), freedom_m(range(3))});
    }
    for (int column = 0; column < columns; ++column) {
      Tangents& wide = widened_[quad(row, column)];
      const int last = std::min(columns - 1, column + surrounding_quads);
      wide = quads_[quad(row, column)];
      for (int other = std::max(0, column - surrounding_quads); other <= last; ++other)
        wide.include(quads_[quad(row, other)]);
    }
  });
  for_rows([&](int row) {
    const int last = std::min(rows - 1, row + surrounding_quads);
    for (int column = 0; column < columns; ++column) {
      Tangents& all = quads_[quad(row, column)];
      all = widened_[quad(row, column)];
      for (int other = std::max(0, row - surrounding_quads); other <= last; ++other)
        all.include(widened_[quad(other, column)]);
    }
  });
}

void PatchTree::refit(std::span<const MovingBox> ranges, double reach_m) {
  reach_m_ = reach_m;
  measure_edges(ranges);
  refit_quads(ranges);
  for (std::size_t index = 0; index < patches_.size(); ++index) {
    const Patch& patch = patches_[index];
    if (patch.is_leaf()) {
      const auto quad = static_cast<std::size_t>(quad_of(static_cast<int>(index)));
      tangents_[index] = quads_[quad];
      const auto corners = grid_.quad(static_cast<int>(quad));
      MovingBox box = ranges[static_cast<std::size_t>(corners[0])];
      for (const int corner : corners) box.include(ranges[static_cast<std::size_t>(corner)]);
      box.grow(reach_m / 2);
      boxes_[index] = box;
    } else {
      const auto first = static_cast<std::size_t>(patch.first_child);
      const auto second = static_cast<std::size_t>(patch.second_child);
      tangents_[index] = tangents_[first];
      tangents_[index].include(tangents_[second]);
      boxes_[index] = boxes_[first];
      boxes_[index].include(boxes_[second]);
    }
  }
  parallel_ranges(patches_.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t index = begin; index < end; ++index)
      flat_[index] = is_flat(tangents_[index]) ? 1 : 0;
  });
}

bool PatchTree::is_flat(const Tangents& tangents) const {
  const Vector3d along = middle(tangents.along.start) + middle(tangents.along.end);
  const Vector3d across = middle(tangents.across.start) + middle(tangents.across.end);
  const Vector3d u = along.normalized();
  const Vector3d v = (across - across.dot(u) * u).normalized();
  const double flatness = std::min(
      least_stretch(tangents.along.start, along_m_, tangents.across.start, across_m_, u, v),
      least_stretch(tangents.along.end, along_m_, tangents.across.end, across_m_, u, v));
  // In the band, features that share no vertex lie at least a corner's height over its quad's
  // diagonal apart. No number compares as less than the reach: what has no frame is not flat.
  const double apart_m = along_m_ * across_m_ / std::hypot(along_m_, across_m_);
  return flatness * apart_m > reach_m_ + 2 * tangents.freedom_m;
}

bool PatchTree::lie_flat(const PatchPair& pair) const {
  if (pair.a == pair.b) return flat_[static_cast<std::size_t>(pair.a)] != 0;
  const Patch& a = at(pair.a);
  const Patch& b = at(pair.b);
  const auto surrounds = [](const Patch& outer, const Patch& inner) {
    return outer.first_row - surrounding_quads <= inner.first_row &&
           inner.end_row <= outer.end_row + surrounding_quads &&
           outer.first_column - surrounding_quads <= inner.first_column &&
           inner.end_column <= outer.end_column + surrounding_quads;
  };
  if (flat_[static_cast<std::size_t>(pair.a)] != 0 && surrounds(a, b)) return true;
  if (flat_[static_cast<std::size_t>(pair.b)] != 0 && surrounds(b, a)) return true;
  const bool one_after_another = a.first_column == b.first_column && a.end_column == b.end_column &&
                                 (a.end_row == b.first_row || b.end_row == a.first_row);
  const bool side_by_side = a.first_row == b.first_row && a.end_row == b.end_row &&
                            (a.end_column == b.first_column || b.end_column == a.first_column);
  if (!one_after_another && !side_by_side) return false;
  Tangents both = tangents_[static_cast<std::size_t>(pair.a)];
  both.include(tangents_[static_cast<std::size_t>(pair.b)]);
  return is_flat(both);
}

bool PatchTree::can_meet(const PatchPair& pair) const {
  if (pair.a != pair.b &&
      !boxes_[static_cast<std::size_t>(pair.a)].meets(boxes_[static_cast<std::size_t>(pair.b)]))
    return false;
  return !lie_flat(pair);
}

void PatchTree::split(const PatchPair& pair, std::vector<PatchPair>& next) const {
  const Patch& a = at(pair.a);
  if (pair.a == pair.b) {
    next.insert(next.end(), {{a.first_child, a.first_child},
                             {a.second_child, a.second_child},
                             {a.first_child, a.second_child}});
    return;
  }
  const Patch& b = at(pair.b);
  if (a.quads() >= b.quads())
    next.insert(next.end(), {{a.first_child, pair.b}, {a.second_child, pair.b}});
  else
    next.insert(next.end(), {{pair.a, b.first_child}, {pair.a, b.second_child}});
}

void PatchTree::list(const PatchPair& pair, std::vector<CandidatePair>& found) const {
  const int a = 2 * quad_of(pair.a);
  const int b = 2 * quad_of(pair.b);
  if (a == b)
    found.push_back({a, a + 1});
  else
    found.insert(found.end(), {{a, b}, {a, b + 1}, {a + 1, b}, {a + 1, b + 1}});
}

std::vector<CandidatePair> PatchTree::pairs_within() const {
  return walk(PatchPair{root(), root()}, [this](const PatchPair& pair, std::vector<PatchPair>& next,
                                                std::vector<CandidatePair>& found) {
    if (!can_meet(pair)) return;
    if (at(pair.a).is_leaf() && at(pair.b).is_leaf())
      list(pair, found);
    else
      split(pair, next);
  });
}

std::vector<CandidatePair> PatchTree::pairs_with(const Hierarchy& other) const {
  struct Pair {
    int patch = 0;
    int node = 0;
  };
  const auto size = [](const MovingBox& box) {
    return (half(box.start) + half(box.end)).squaredNorm();
  };
  return walk(Pair{root(), other.root()}, [&](const Pair& pair, std::vector<Pair>& next,
                                              std::vector<CandidatePair>& found) {
    const MovingBox& box = boxes_[static_cast<std::size_t>(pair.patch)];
    MovingBox grown = other.box(pair.node);
    grown.grow(reach_m_ / 2);
    if (!box.meets(grown)) return;
    const Patch& patch = at(pair.patch);
    const bool node_is_leaf = other.is_leaf(pair.node);
    if (patch.is_leaf() && node_is_leaf) {
      const int triangle = 2 * quad_of(pair.patch);
      found.insert(found.end(), {{triangle, pair.node}, {triangle + 1, pair.node}});
    } else if (!patch.is_leaf() && (node_is_leaf || size(box) >= size(grown))) {
      next.insert(next.end(), {{patch.first_child, pair.node}, {patch.second_child, pair.node}});
    } else {
      for (const int child : other.children(pair.node)) next.push_back({pair.patch, child});
    }
  });
}

}  // namespace ribbon

#include "simulation/detection/ribbon_bvh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "geometry/vectors.h"
#include "parallel/parallel.h"
#include "simulation/detection/bvh_walk.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;

constexpr int margin = 1;  // blocks to every side of a patch that are looked at with it
constexpr int patches_to_a_branch = 256;

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
  return length_of(half(range.end));
}

// In the frame u, v: a lower bound of the smallest eigenvalue of the symmetric part of a matrix
// whose columns are an edge along over along_m and an edge across over across_m.
double least_stretch(const Box& along, double along_m, const Box& across, double across_m,
                     const Vector3d& u, const Vector3d& v) {
  const Vector3d a = middle(along) / along_m;
  const Vector3d c = middle(across) / across_m;
  const Vector3d a_spread = half(along) / along_m;
  const Vector3d c_spread = half(across) / across_m;
  const double p = dot(a, u) - dot(a_spread, u.cwiseAbs());
  const double s = dot(c, v) - dot(c_spread, v.cwiseAbs());
  const double q = (std::abs(dot(a, v) + dot(c, u)) + dot(a_spread, v.cwiseAbs()) +
                    dot(c_spread, u.cwiseAbs())) /
                   2;
  return (p + s) / 2 - std::sqrt((p - s) * (p - s) / 4 + q * q);
}

// Which of the flags are set.
std::vector<int> numbers_of(const std::vector<char>& flags) {
  std::vector<int> numbers;
  for (int number = 0; number < std::ssize(flags); ++number)
    if (flags[number] != 0) numbers.push_back(number);
  return numbers;
}

template <class Body>
void for_each_parallel(std::span<const int> rows, const Body& body) {
  parallel_ranges(rows.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (const int row : rows.subspan(begin, end - begin)) body(row);
  });
}

}  // namespace

void RibbonBvh::Tangents::include(const Tangents& other) {
  along.include(other.along);
  across.include(other.across);
  freedom_m = std::max(freedom_m, other.freedom_m);
}

RibbonBvh::RibbonBvh(const RibbonGrid& grid)
    : grid_(grid),
      block_rows_((grid.along - 1 + block_side - 1) / block_side),
      block_columns_((grid.across - 1 + block_side - 1) / block_side) {
  build({.first_row = 0, .end_row = block_rows_, .first_column = 0, .end_column = block_columns_});
  boxes_.resize(patches_.size());
  share_out();
  tangents_.resize(patches_.size());
  flat_.resize(patches_.size());
  looked_at_.resize(patches_.size());
  blocks_.resize(static_cast<std::size_t>(block_rows_) * static_cast<std::size_t>(block_columns_));
  widened_.resize(blocks_.size());
}

// Returns the patch's number. The longer side is halved.
int RibbonBvh::build(Patch patch) {
  if (patch.blocks() > 1) {
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

// Children come before their parents, so the patches of a branch follow each other. Branches can be
// refitted side by side.
void RibbonBvh::share_out() {
  std::vector<int> sizes(patches_.size(), 1);
  const auto size = [&](int patch) -> int& { return sizes[patch]; };
  for (int patch = 0; patch <= root(); ++patch)
    if (!at(patch).is_leaf())
      size(patch) += size(at(patch).first_child) + size(at(patch).second_child);
  for (int patch = root(); patch >= 0; --patch) {
    if (size(patch) > patches_to_a_branch) {
      trunk_.push_back(patch);
      continue;
    }
    branches_.push_back(patch);
    patch -= size(patch) - 1;
  }
  std::reverse(branches_.begin(), branches_.end());
  std::reverse(trunk_.begin(), trunk_.end());
}

// The yardstick of flatness: any would do, this one lets most patches pass.
void RibbonBvh::measure_edges(std::span<const MovingBox> ranges) {
  const auto length_m = [&](int a, int b) {
    return length_of(ranges[b].start.low - ranges[a].start.low);
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

BlockFeatures RibbonBvh::features_of(int leaf) const {
  return {grid_, at(leaf).first_row, at(leaf).first_column, vertices_};
}

RibbonBvh::Tangents RibbonBvh::tangents_of_block(std::span<const MovingBox> ranges, int block_row,
                                                 int block_column) const {
  const int last_row = std::min(grid_.along - 1, block_side * (block_row + 1));
  const int last_column = std::min(grid_.across - 1, block_side * (block_column + 1));
  const auto range = [&](int row, int column) -> const MovingBox& {
    return ranges[grid_.particle(row, column)];
  };
  const int first_row = block_side * block_row;
  const int first_column = block_side * block_column;
  const MovingBox& corner = range(first_row, first_column);
  Tangents tangents{edge(corner, range(first_row + 1, first_column)),
                    edge(corner, range(first_row, first_column + 1)), 0};
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column) {
      const MovingBox& here = range(row, column);
      tangents.freedom_m = std::max(tangents.freedom_m, freedom_m(here));
      if (row < last_row) tangents.along.include(edge(here, range(row + 1, column)));
      if (column < last_column) tangents.across.include(edge(here, range(row, column + 1)));
    }
  return tangents;
}

// Of the blocks of these rows with what lies beside them in their row.
void RibbonBvh::widen_blocks(std::span<const MovingBox> ranges, std::span<const int> rows) {
  for_each_parallel(rows, [&](int row) {
    for (int column = 0; column < block_columns_; ++column)
      blocks_[block_number(row, column)] = tangents_of_block(ranges, row, column);
    for (int column = 0; column < block_columns_; ++column) {
      Tangents& wide = widened_[block_number(row, column)];
      wide = blocks_[block_number(row, column)];
      const int last = std::min(block_columns_ - 1, column + margin);
      for (int other = std::max(0, column - margin); other <= last; ++other)
        wide.include(blocks_[block_number(row, other)]);
    }
  });
}

// Of the blocks of these rows with all of their margin, from what widen_blocks() left.
void RibbonBvh::join_blocks(std::span<const int> rows) {
  for_each_parallel(rows, [&](int row) {
    const int last = std::min(block_rows_ - 1, row + margin);
    for (int column = 0; column < block_columns_; ++column) {
      Tangents& all = blocks_[block_number(row, column)];
      all = widened_[block_number(row, column)];
      for (int other = std::max(0, row - margin); other <= last; ++other)
        all.include(widened_[block_number(other, column)]);
    }
  });
}

// Grown by half the reach, about the first particle, near which the others are.
PackedBox RibbonBvh::packed(MovingBox range) const {
  range.grow(reach_m_ / 2);
  return PackedBox::around(range, origin_);
}

void RibbonBvh::pack(std::span<const MovingBox> ranges) {
  origin_ = ranges.front().start.low;
  vertices_.resize(ranges.size());
  parallel_ranges(ranges.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t vertex = begin; vertex < end; ++vertex)
      vertices_[vertex] = packed(ranges[vertex]);
  });
}

PackedBox RibbonBvh::box_of_leaf(int leaf) const {
  const int end_row = std::min(grid_.along - 1, block_side * at(leaf).end_row);
  const int end_column = std::min(grid_.across - 1, block_side * at(leaf).end_column);
  const auto vertex = [&](int row, int column) -> const PackedBox& {
    return vertices_[grid_.particle(row, column)];
  };
  PackedBox box = vertex(end_row, end_column);
  for (int row = block_side * at(leaf).first_row; row <= end_row; ++row)
    for (int column = block_side * at(leaf).first_column; column <= end_column; ++column)
      box.include(vertex(row, column));
  return box;
}

void RibbonBvh::refit_patch(int patch) {
  const int index = patch;
  if (at(patch).is_leaf()) {
    tangents_[index] = blocks_[block_of(patch)];
    boxes_[index] = box_of_leaf(patch);
  } else {
    const int first = at(patch).first_child;
    const int second = at(patch).second_child;
    tangents_[index] = tangents_[first];
    tangents_[index].include(tangents_[second]);
    boxes_[index] = boxes_[first];
    boxes_[index].include(boxes_[second]);
  }
  flat_[index] = is_flat(tangents_[index]) ? 1 : 0;
}

// Those for which the rows of blocks between are stale: children come before their parents.
void RibbonBvh::refit_patches(const std::vector<char>& is_stale_row) {
  std::vector<int> stale_before(is_stale_row.size() + 1, 0);
  std::inclusive_scan(is_stale_row.begin(), is_stale_row.end(), stale_before.begin() + 1,
                      std::plus<>(), 0);
  const auto refit_if_stale = [&](int patch) {
    if (stale_before[at(patch).first_row] < stale_before[at(patch).end_row]) refit_patch(patch);
  };
  parallel_ranges(branches_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t branch = begin; branch < end; ++branch) {
      int patch = branches_[branch];
      while (!at(patch).is_leaf()) patch = at(patch).first_child;
      for (; patch <= branches_[branch]; ++patch) refit_if_stale(patch);
    }
  });
  for (const int patch : trunk_) refit_if_stale(patch);
}

void RibbonBvh::refit(std::span<const MovingBox> ranges, double reach_m) {
  reach_m_ = reach_m;
  pack(ranges);
  measure_edges(ranges);
  std::vector<int> rows(block_rows_);
  std::iota(rows.begin(), rows.end(), 0);
  widen_blocks(ranges, rows);
  join_blocks(rows);
  refit_patches(std::vector<char>(rows.size(), 1));
  std::fill(looked_at_.begin(), looked_at_.end(), 1);
}

void RibbonBvh::refit_around(std::span<const int> particles, std::span<const MovingBox> ranges) {
  std::vector<char> has_particle(block_rows_, 0);
  for (const int particle : particles) {
    vertices_[particle] = packed(ranges[particle]);
    for (const int quad_row : {grid_.row(particle) - 1, grid_.row(particle)})
      if (quad_row >= 0 && quad_row < grid_.along - 1) has_particle[quad_row / block_side] = 1;
  }
  std::vector<char> is_stale(block_rows_, 0);  // by their margins
  for (int row = 0; row < block_rows_; ++row)
    for (int other = std::max(0, row - margin); other <= std::min(block_rows_ - 1, row + margin);
         ++other)
      if (has_particle[other] != 0) is_stale[row] = 1;
  widen_blocks(ranges, numbers_of(has_particle));
  join_blocks(numbers_of(is_stale));
  refit_patches(is_stale);
  look_only_at(particles);
}

// A particle on the border of a block belongs to its neighbours as well.
void RibbonBvh::look_only_at(std::span<const int> particles) {
  std::vector<char> blocks(blocks_.size(), 0);
  for (const int particle : particles) {
    const int row = grid_.row(particle);
    const int column = grid_.column(particle);
    for (const int i : {row - 1, row})
      for (const int j : {column - 1, column})
        if (i >= 0 && i < grid_.along - 1 && j >= 0 && j < grid_.across - 1)
          blocks[block_at(i, j)] = 1;
  }
  for (int patch = 0; patch <= root(); ++patch) {
    const bool is_looked = at(patch).is_leaf() ? blocks[block_of(patch)] != 0
                                               : is_looked_at(at(patch).first_child) ||
                                                     is_looked_at(at(patch).second_child);
    looked_at_[patch] = is_looked ? 1 : 0;
  }
}

bool RibbonBvh::is_flat(const Tangents& tangents) const {
  const Vector3d along = middle(tangents.along.start) + middle(tangents.along.end);
  const Vector3d across = middle(tangents.across.start) + middle(tangents.across.end);
  const Vector3d u = normalised(along);
  const Vector3d v = normalised(across - dot(across, u) * u);
  const double flatness = std::min(
      least_stretch(tangents.along.start, along_m_, tangents.across.start, across_m_, u, v),
      least_stretch(tangents.along.end, along_m_, tangents.across.end, across_m_, u, v));
  // In the band, features that share no vertex lie at least a corner's height over its quad's
  // diagonal apart. No number compares as less than the reach: what has no frame is not flat.
  const double apart_m = along_m_ * across_m_ / length_of(Eigen::Vector2d(along_m_, across_m_));
  return flatness * apart_m > reach_m_ + 2 * tangents.freedom_m;
}

bool RibbonBvh::lie_flat(const PatchPair& pair) const {
  if (pair.a == pair.b) return flat_[pair.a] != 0;
  const Patch& a = at(pair.a);
  const Patch& b = at(pair.b);
  const auto holds_with_margin = [](const Patch& outer, const Patch& inner) {
    return outer.first_row - margin <= inner.first_row && inner.end_row <= outer.end_row + margin &&
           outer.first_column - margin <= inner.first_column &&
           inner.end_column <= outer.end_column + margin;
  };
  if (flat_[pair.a] != 0 && holds_with_margin(a, b)) return true;
  if (flat_[pair.b] != 0 && holds_with_margin(b, a)) return true;
  const bool one_after_another = a.first_column == b.first_column && a.end_column == b.end_column &&
                                 (a.end_row == b.first_row || b.end_row == a.first_row);
  const bool side_by_side = a.first_row == b.first_row && a.end_row == b.end_row &&
                            (a.end_column == b.first_column || b.end_column == a.first_column);
  if (!one_after_another && !side_by_side) return false;
  Tangents both = tangents_[pair.a];
  both.include(tangents_[pair.b]);
  return is_flat(both);
}

bool RibbonBvh::can_meet(const PatchPair& pair) const {
  if (!is_looked_at(pair.a) && !is_looked_at(pair.b)) return false;
  if (pair.a != pair.b && !boxes_[pair.a].meets(boxes_[pair.b])) return false;
  return !lie_flat(pair);
}

void RibbonBvh::split(const PatchPair& pair, std::vector<PatchPair>& next) const {
  const Patch& a = at(pair.a);
  if (pair.a == pair.b) {
    next.insert(next.end(), {{a.first_child, a.first_child},
                             {a.second_child, a.second_child},
                             {a.first_child, a.second_child}});
    return;
  }
  const Patch& b = at(pair.b);
  if (a.blocks() >= b.blocks())
    next.insert(next.end(), {{a.first_child, pair.b}, {a.second_child, pair.b}});
  else
    next.insert(next.end(), {{pair.a, b.first_child}, {pair.a, b.second_child}});
}

void RibbonBvh::list(const PatchPair& pair, std::vector<FeaturePair>& found) const {
  const BlockFeatures of_a = features_of(pair.a);
  if (pair.a == pair.b)
    of_a.list_within(found);
  else
    of_a.list_between(features_of(pair.b), found);
}

std::vector<FeaturePair> RibbonBvh::pairs_within() const {
  return walk<FeaturePair>(
      PatchPair{root(), root()},
      [&](const PatchPair& pair, std::vector<PatchPair>& next, std::vector<FeaturePair>& found) {
        if (!can_meet(pair)) return;
        if (at(pair.a).is_leaf() && at(pair.b).is_leaf())
          list(pair, found);
        else
          split(pair, next);
      });
}

std::vector<FeaturePair> RibbonBvh::pairs_with(const CollisionSurface& obstacle,
                                               const TriangleBvh& bvh,
                                               const Eigen::Matrix3Xd& vertices) const {
  struct Pair {
    int patch = 0;
    int node = 0;
  };
  const auto size = [](const PackedBox& box) {
    return squared_length_of((box.start_high - box.start_low).matrix()) +
           squared_length_of((box.end_high - box.end_low).matrix());
  };
  const auto box_of_corner = [&](int triangle, int corner) {
    const Box at = Box::around(vertices.col(obstacle.triangles(corner, triangle)));
    return packed({at, at});
  };
  return walk<FeaturePair>(Pair{root(), bvh.root()}, [&](const Pair& pair, std::vector<Pair>& next,
                                                         std::vector<FeaturePair>& found) {
    if (!is_looked_at(pair.patch)) return;
    const PackedBox& box = boxes_[pair.patch];
    const PackedBox other = packed(bvh.box(pair.node));
    if (!box.meets(other)) return;
    const Patch& patch = at(pair.patch);
    const bool node_is_leaf = bvh.is_leaf(pair.node);
    if (patch.is_leaf() && node_is_leaf) {
      features_of(pair.patch)
          .list_with(obstacle, grid_.particle_count(), pair.node,
                     {box_of_corner(pair.node, 0), box_of_corner(pair.node, 1),
                      box_of_corner(pair.node, 2)},
                     found);
    } else if (!patch.is_leaf() && (node_is_leaf || size(box) >= size(other))) {
      next.insert(next.end(), {{patch.first_child, pair.node}, {patch.second_child, pair.node}});
    } else {
      for (const int child : bvh.children(pair.node)) next.push_back({pair.patch, child});
    }
  });
}

}  // namespace ribbon

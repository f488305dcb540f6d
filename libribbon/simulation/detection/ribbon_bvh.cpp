#include "simulation/detection/ribbon_bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "geometry/vectors.h"
#include "parallel/parallel.h"

namespace ribbon {

namespace {

using Eigen::Vector3d;

constexpr int margin = 1;  // blocks to every side of a patch that are looked at with it
constexpr int patches_to_a_branch = 256;
constexpr double roomy = 1 + 1e-6;  // more than rounding takes from a distance

Vector3d middle(const Box& box) {
  return (box.low + box.high) / 2;
}

Vector3d half(const Box& box) {
  return (box.high - box.low) / 2;
}

// Encloses nothing yet.
Box nothing() {
  const Vector3d infinite = Vector3d::Constant(std::numeric_limits<double>::infinity());
  return {infinite, -infinite};
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

using Coordinates = std::array<double, 6>;

void lower(Coordinates& lowest, const Coordinates& other) {
  for (std::size_t k = 0; k < lowest.size(); ++k) lowest[k] = std::min(lowest[k], other[k]);
}

void raise(Coordinates& highest, const Coordinates& other) {
  for (std::size_t k = 0; k < highest.size(); ++k) highest[k] = std::max(highest[k], other[k]);
}

Coordinates difference(const Coordinates& to, const Coordinates& from) {
  Coordinates result;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = to[k] - from[k];
  return result;
}

template <class Body>
void for_each_parallel(std::span<const int> rows, const Body& body) {
  parallel_ranges(rows.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (const int row : rows.subspan(begin, end - begin)) body(row);
  });
}

}  // namespace

void RibbonBvh::Tangents::include(const Tangents& other) {
  lower(lowest_along, other.lowest_along);
  raise(highest_along, other.highest_along);
  lower(lowest_across, other.lowest_across);
  raise(highest_across, other.highest_across);
  freedom_m = std::max(freedom_m, other.freedom_m);
}

Box RibbonBvh::Tangents::along(int end) const {
  return {Vector3d(lowest_along.data() + std::ptrdiff_t{3} * end),
          Vector3d(highest_along.data() + std::ptrdiff_t{3} * end)};
}

Box RibbonBvh::Tangents::across(int end) const {
  return {Vector3d(lowest_across.data() + std::ptrdiff_t{3} * end),
          Vector3d(highest_across.data() + std::ptrdiff_t{3} * end)};
}

RibbonBvh::RibbonBvh(const RibbonGrid& grid)
    : grid_(grid),
      block_rows_((grid.along - 1 + block_side - 1) / block_side),
      block_columns_((grid.across - 1 + block_side - 1) / block_side),
      shapes_{BlockShape(grid, 0, 0), BlockShape(grid, 0, block_columns_ - 1),
              BlockShape(grid, block_rows_ - 1, 0),
              BlockShape(grid, block_rows_ - 1, block_columns_ - 1)} {
  build({.first_row = 0, .end_row = block_rows_, .first_column = 0, .end_column = block_columns_});
  boxes_.resize(patches_.size());
  share_out();
  tangents_.resize(patches_.size());
  flat_.resize(patches_.size());
  looked_at_.resize(patches_.size());
  vertices_.resize(grid.particle_count());
  middles_.resize(grid.particle_count());
  is_named_.resize(grid.particle_count());
  leaves_.resize(static_cast<std::size_t>(block_rows_) * static_cast<std::size_t>(block_columns_));
  for (int patch = 0; patch <= root(); ++patch)
    if (at(patch).is_leaf()) leaves_[block_of(patch)] = patch;
  widened_.resize(leaves_.size());
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
  // A corner's height over its quad's diagonal.
  apart_m_ = along_m_ * across_m_ / length_of(Eigen::Vector2d(along_m_, across_m_));
}

RibbonBvh::Tangents RibbonBvh::tangents_of_block(int block_row, int block_column) const {
  const int first_row = block_side * block_row;
  const int first_column = block_side * block_column;
  const int last_row = std::min(grid_.along - 1, first_row + block_side);
  const int last_column = std::min(grid_.across - 1, first_column + block_side);
  const auto middle = [&](int row, int column) -> const Middle& {
    return middles_[grid_.particle(row, column)];
  };
  const Middle& corner = middle(first_row, first_column);
  const Coordinates along = difference(middle(first_row + 1, first_column).at, corner.at);
  const Coordinates across = difference(middle(first_row, first_column + 1).at, corner.at);
  Tangents tangents{along, along, across, across, 0};
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column) {
      const Middle& here = middle(row, column);
      tangents.freedom_m = std::max(tangents.freedom_m, here.freedom_m);
      if (row < last_row) {
        const Coordinates edge = difference(middle(row + 1, column).at, here.at);
        lower(tangents.lowest_along, edge);
        raise(tangents.highest_along, edge);
      }
      if (column < last_column) {
        const Coordinates edge = difference(middle(row, column + 1).at, here.at);
        lower(tangents.lowest_across, edge);
        raise(tangents.highest_across, edge);
      }
    }
  return tangents;
}

// Of the blocks of these rows with what lies beside them in their row.
void RibbonBvh::widen_blocks(std::span<const int> rows) {
  for_each_parallel(rows, [&](int row) {
    Tangents* const widened = &widened_[block_number(row, 0)];
    Tangents here = tangents_of_block(row, 0);
    widened[0] = here;
    for (int column = 1; column < block_columns_; ++column) {
      const Tangents before = here;
      here = tangents_of_block(row, column);
      widened[column - 1].include(here);
      widened[column] = here;
      widened[column].include(before);
    }
  });
}

// Of the blocks of these rows with all of their margin, from what widen_blocks() left.
void RibbonBvh::join_blocks(std::span<const int> rows) {
  for_each_parallel(rows, [&](int row) {
    const int last = std::min(block_rows_ - 1, row + margin);
    for (int column = 0; column < block_columns_; ++column) {
      Tangents& all = tangents_[leaves_[block_number(row, column)]];
      all = widened_[block_number(row, column)];
      for (int other = std::max(0, row - margin); other <= last; ++other)
        if (other != row) all.include(widened_[block_number(other, column)]);
    }
  });
}

void RibbonBvh::take_range(int particle, const MovingBox& range) {
  vertices_[particle] = packed(range);
  const Vector3d start = middle(range.start);
  const Vector3d end = middle(range.end);
  middles_[particle] = {{start.x(), start.y(), start.z(), end.x(), end.y(), end.z()},
                        length_of(half(range.end))};
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
    boxes_[index] = box_of_leaf(patch);
  } else {
    const int first = at(patch).first_child;
    const int second = at(patch).second_child;
    tangents_[index] = tangents_[first];
    tangents_[index].include(tangents_[second]);
    boxes_[index] = boxes_[first];
    boxes_[index].include(boxes_[second]);
  }
  flat_[index] = Flat::unknown;
}

// Those that have stale rows of blocks: children come before their parents.
void RibbonBvh::refit_patches() {
  stale_before_.assign(block_rows_ + 1, 0);
  for (const int row : stale_rows_) stale_before_[row + 1] = 1;
  std::partial_sum(stale_before_.begin(), stale_before_.end(), stale_before_.begin());
  const auto refit_if_stale = [&](int patch) {
    if (stale_before_[at(patch).first_row] < stale_before_[at(patch).end_row]) refit_patch(patch);
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
  origin_ = ranges.front().start.low;
  parallel_ranges(ranges.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t particle = begin; particle < end; ++particle)
      take_range(static_cast<int>(particle), ranges[particle]);
  });
  measure_edges(ranges);
  stale_rows_.resize(block_rows_);
  std::iota(stale_rows_.begin(), stale_rows_.end(), 0);
  widen_blocks(stale_rows_);
  join_blocks(stale_rows_);
  refit_patches();
  std::fill(looked_at_.begin(), looked_at_.end(), 1);
  std::fill(is_named_.begin(), is_named_.end(), 1);
}

void RibbonBvh::refit_around(std::span<const int> particles, std::span<const MovingBox> ranges) {
  has_changed_.assign(block_rows_, 0);
  for (const int particle : particles) {
    take_range(particle, ranges[particle]);
    for (const int quad_row : {grid_.row(particle) - 1, grid_.row(particle)})
      if (quad_row >= 0 && quad_row < grid_.along - 1) has_changed_[quad_row / block_side] = 1;
  }
  changed_rows_.clear();
  stale_rows_.clear();
  for (int row = 0; row < block_rows_; ++row) {
    if (has_changed_[row] != 0) changed_rows_.push_back(row);
    const auto begin = has_changed_.begin() + std::max(0, row - margin);
    const auto end = has_changed_.begin() + std::min(block_rows_, row + margin + 1);
    if (std::find(begin, end, 1) != end) stale_rows_.push_back(row);
  }
  widen_blocks(changed_rows_);
  join_blocks(stale_rows_);
  refit_patches();
  look_only_at(particles);
}

// A particle on the border of a block belongs to its neighbours as well.
void RibbonBvh::look_only_at(std::span<const int> particles) {
  std::fill(is_named_.begin(), is_named_.end(), 0);
  has_changed_.assign(leaves_.size(), 0);
  for (const int particle : particles) {
    is_named_[particle] = 1;
    const int row = grid_.row(particle);
    const int column = grid_.column(particle);
    for (const int i : {row - 1, row})
      for (const int j : {column - 1, column})
        if (i >= 0 && i < grid_.along - 1 && j >= 0 && j < grid_.across - 1)
          has_changed_[block_at(i, j)] = 1;
  }
  for (int patch = 0; patch <= root(); ++patch) {
    const bool is_looked = at(patch).is_leaf() ? has_changed_[block_of(patch)] != 0
                                               : is_looked_at(at(patch).first_child) ||
                                                     is_looked_at(at(patch).second_child);
    looked_at_[patch] = is_looked ? 1 : 0;
  }
}

bool RibbonBvh::are_flat(const Tangents& tangents) const {
  const std::array<Box, 2> along{tangents.along(0), tangents.along(1)};
  const std::array<Box, 2> across{tangents.across(0), tangents.across(1)};
  const Vector3d u = normalised(middle(along[0]) + middle(along[1]));
  const Vector3d mean_across = middle(across[0]) + middle(across[1]);
  const Vector3d v = normalised(mean_across - dot(mean_across, u) * u);
  const double wanted_m = reach_m_ + 2 * tangents.freedom_m;
  // No number compares as less than the reach: what has no frame is not flat.
  return least_stretch(along[0], along_m_, across[0], across_m_, u, v) * apart_m_ > wanted_m &&
         least_stretch(along[1], along_m_, across[1], across_m_, u, v) * apart_m_ > wanted_m;
}

// Whoever asks first on any core finds the same answer. (By the compilers' own functions: libc++
// has no std::atomic_ref.)
bool RibbonBvh::is_flat(int patch) {
  Flat flat = Flat::unknown;
  __atomic_load(&flat_[patch], &flat, __ATOMIC_RELAXED);
  if (flat == Flat::unknown) {
    flat = are_flat(tangents_[patch]) ? Flat::yes : Flat::no;
    __atomic_store(&flat_[patch], &flat, __ATOMIC_RELAXED);
  }
  return flat == Flat::yes;
}

bool RibbonBvh::lie_flat(const PatchPair& pair) {
  if (pair.a == pair.b) return is_flat(pair.a);
  const Patch& a = at(pair.a);
  const Patch& b = at(pair.b);
  const auto holds_with_margin = [](const Patch& outer, const Patch& inner) {
    return outer.first_row - margin <= inner.first_row && inner.end_row <= outer.end_row + margin &&
           outer.first_column - margin <= inner.first_column &&
           inner.end_column <= outer.end_column + margin;
  };
  if (holds_with_margin(a, b) && is_flat(pair.a)) return true;
  if (holds_with_margin(b, a) && is_flat(pair.b)) return true;
  const bool one_after_another = a.first_column == b.first_column && a.end_column == b.end_column &&
                                 (a.end_row == b.first_row || b.end_row == a.first_row);
  const bool side_by_side = a.first_row == b.first_row && a.end_row == b.end_row &&
                            (a.end_column == b.first_column || b.end_column == a.first_column);
  if (!one_after_another && !side_by_side) return false;
  Tangents both = tangents_[pair.a];
  both.include(tangents_[pair.b]);
  return are_flat(both);
}

// Most pairs of neighbouring blocks are neither flat with their margins nor come their features
// close. The rectangle around the two alone is flatter, and where its particles move alike it has
// to be so only at the start.
bool RibbonBvh::stay_apart(const PatchPair& pair) const {
  const Patch& a = at(pair.a);
  const Patch& b = at(pair.b);
  const int first_row = std::min(a.first_row, b.first_row);
  const int first_column = std::min(a.first_column, b.first_column);
  const int end_row = std::max(a.end_row, b.end_row);
  const int end_column = std::max(a.end_column, b.end_column);
  if (end_row - first_row > 2 || end_column - first_column > 2) return false;
  const int last_row = std::min(grid_.along - 1, block_side * end_row);
  const int last_column = std::min(grid_.across - 1, block_side * end_column);
  Box along = nothing();
  Box across = nothing();
  Box displacement = nothing();
  double freedom_m = 0;
  const auto start = [](const Middle& of) { return Eigen::Map<const Vector3d>(of.at.data()); };
  for (int row = block_side * first_row; row <= last_row; ++row)
    for (int column = block_side * first_column; column <= last_column; ++column) {
      const Middle* const here = &middles_[grid_.particle(row, column)];
      displacement.include(Eigen::Map<const Vector3d>(here->at.data() + 3) - start(*here));
      freedom_m = std::max(freedom_m, here->freedom_m);
      if (row < last_row) along.include(start(here[grid_.across]) - start(*here));
      if (column < last_column) across.include(start(here[1]) - start(*here));
    }
  const Vector3d u = normalised(middle(along));
  const Vector3d v = normalised(middle(across) - dot(middle(across), u) * u);
  const double flatness = least_stretch(along, along_m_, across, across_m_, u, v);
  const double approach_m = length_of(displacement.high - displacement.low) + 2 * freedom_m;
  return flatness * apart_m_ > roomy * (reach_m_ + approach_m);
}

bool RibbonBvh::can_meet(const PatchPair& pair) {
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

// The features of the blocks that were asked for last: partners follow each other.
class RibbonBvh::RecentBlocks {
 public:
  explicit RecentBlocks(const RibbonBvh& tree) : tree_(tree) { leaves_.fill(-1); }

  const BlockFeatures& operator[](int leaf) {
    const std::size_t place = tree_.block_of(leaf) % leaves_.size();
    if (leaves_[place] != leaf) {
      leaves_[place] = leaf;
      // In place: they are large.
      std::construct_at(&features_[place], tree_.shape_of(leaf), tree_.first_particle(leaf),
                        tree_.vertices_, tree_.is_named_);
    }
    return features_[place];
  }

 private:
  const RibbonBvh& tree_;
  std::array<int, 16> leaves_;
  std::array<BlockFeatures, 16> features_;
};

// Appends what list(begin, end, found) lists for ranges that cover [0, count), in order.
template <class List>
void RibbonBvh::list_in_parts(std::size_t count, const List& list,
                              std::vector<FeaturePair>& found) {
  const std::size_t parts = parts_of(count);
  parts_.resize(std::max(parts_.size(), parts));
  parallel_ranges(count, grain, [&](std::size_t begin, std::size_t end) {
    std::vector<FeaturePair>& part = parts_[begin / grain];
    part.clear();
    list(begin, end, part);
  });
  for (std::size_t part = 0; part < parts; ++part)
    found.insert(found.end(), parts_[part].begin(), parts_[part].end());
}

const std::vector<RibbonBvh::PatchPair>& RibbonBvh::leaves_within() {
  return walk_within_.from(
      {root(), root()},
      [&](const PatchPair& pair, std::vector<PatchPair>& next, std::vector<PatchPair>& found) {
        if (!can_meet(pair)) return;
        if (!at(pair.a).is_leaf() || !at(pair.b).is_leaf())
          split(pair, next);
        else if (!stay_apart(pair))
          found.push_back(pair);
      });
}

void RibbonBvh::list_within(std::vector<FeaturePair>& found) {
  const std::vector<PatchPair>& leaves = leaves_within();
  const auto list_range = [&](std::size_t begin, std::size_t end, std::vector<FeaturePair>& part) {
    RecentBlocks of_a(*this);
    RecentBlocks of_b(*this);
    for (std::size_t i = begin; i < end; ++i)
      list(leaves[i], of_a[leaves[i].a], of_b[leaves[i].b], part);
  };
  list_in_parts(leaves.size(), list_range, found);
}

const std::vector<RibbonBvh::PatchAndNode>& RibbonBvh::leaves_with(const TriangleBvh& bvh) {
  const auto size = [](const PackedBox& box) {
    return squared_length_of((box.start_high - box.start_low).matrix()) +
           squared_length_of((box.end_high - box.end_low).matrix());
  };
  return walk_with_.from({root(), bvh.root()}, [&](const PatchAndNode& pair,
                                                   std::vector<PatchAndNode>& next,
                                                   std::vector<PatchAndNode>& found) {
    if (!is_looked_at(pair.patch)) return;
    const PackedBox& box = boxes_[pair.patch];
    const PackedBox other = packed(bvh.box(pair.node).start);  // it never moves
    if (!box.meets(other)) return;
    const Patch& patch = at(pair.patch);
    const bool node_is_leaf = bvh.is_leaf(pair.node);
    if (patch.is_leaf() && node_is_leaf) {
      found.push_back(pair);
    } else if (!patch.is_leaf() && (node_is_leaf || size(box) >= size(other))) {
      next.insert(next.end(), {{patch.first_child, pair.node}, {patch.second_child, pair.node}});
    } else {
      for (const int child : bvh.children(pair.node)) next.push_back({pair.patch, child});
    }
  });
}

ObstacleTriangle RibbonBvh::boxed(const CollisionSurface& obstacle,
                                  const Eigen::Matrix3Xd& vertices, int triangle) const {
  const auto box_of_corner = [&](int corner) {
    return packed(Box::around(vertices.col(obstacle.triangles(corner, triangle))));
  };
  return {obstacle,
          grid_.particle_count(),
          triangle,
          {box_of_corner(0), box_of_corner(1), box_of_corner(2)}};
}

void RibbonBvh::list_with(const CollisionSurface& obstacle, const TriangleBvh& bvh,
                          const Eigen::Matrix3Xd& vertices, std::vector<FeaturePair>& found) {
  const std::vector<PatchAndNode>& leaves = leaves_with(bvh);
  const auto list_range = [&](std::size_t begin, std::size_t end, std::vector<FeaturePair>& part) {
    RecentBlocks blocks(*this);
    for (std::size_t i = begin; i < end; ++i)
      blocks[leaves[i].patch].list_with(boxed(obstacle, vertices, leaves[i].node), part);
  };
  list_in_parts(leaves.size(), list_range, found);
}

}  // namespace ribbon

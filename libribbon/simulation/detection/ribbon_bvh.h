// A tree over rectangular patches of the ribbon that tells what lies too flat to meet itself.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "geometry/ribbon_grid.h"
#include "parallel/parallel.h"
#include "simulation/detection/block_features.h"
#include "simulation/detection/bvh_walk.h"
#include "simulation/detection/feature_pairs.h"
#include "simulation/detection/triangle_bvh.h"

namespace ribbon {

// The gate's answer to the paper's hierarchy (section 5.4.3), in which curvature spares adjacent
// regions and boxes the others. Curvature by normals overlooks a band that lies flat over itself;
// here a patch is spared only on proof. Seen in one frame of two directions, a rectangle whose
// tangents along s and across t keep the symmetric part of d(x)/d(s,t) above `flatness` > 0 brings
// no two of its points closer than flatness times their distance in the band (the classic condition
// for a map of a convex region to be one-to-one, with its factor). It is linear in the positions:
// what holds at the start and at the end of straight ways holds all the time between.
//
// The leaves are blocks of two by two quads. Each patch is looked at with a margin of one block to
// every side, so that a patch and a small neighbour lie in one rectangle. Built once, refitted for
// each detection.
class RibbonBvh {
 public:
  explicit RibbonBvh(const RibbonGrid& grid);

  // Over the ranges of the particles. reach_m: pairs that cannot come this close are spared.
  void refit(std::span<const MovingBox> ranges, double reach_m);

  // Likewise, where the ranges are those of the last refit but for these particles. Until the next
  // refit, pairs that have none of them are left out.
  void refit_around(std::span<const int> particles, std::span<const MovingBox> ranges);

  // Appends the pairs of features of the ribbon that share no vertex and may come within the reach
  // of each other, each once, in an order that depends on nothing but the ranges.
  void list_within(std::vector<FeaturePair>& found);

  // Likewise, of the ribbon and of the still obstacle (3 x vertices), numbered after the particles.
  void list_with(const CollisionSurface& obstacle, const TriangleBvh& bvh,
                 const Eigen::Matrix3Xd& vertices, std::vector<FeaturePair>& found);

  // A part of the ribbon: these rows and all between.
  struct Rows {
    int first = 0;
    int last = 0;
  };

  // Takes the same pairs in parts that lie in few rows, but leaves out parts in whose rows nobody
  // is interested any more: is_wanted(rows), take(pairs). Both are called on all cores at a time,
  // in any order.
  template <class IsWanted, class Take>
  void visit_within(const IsWanted& is_wanted, const Take& take) {
    const std::vector<PatchPair>& leaves = leaves_within();
    visit_in_parts(leaves.size(), take, [&](std::size_t i, std::vector<FeaturePair>& visited) {
      const PatchPair& pair = leaves[i];
      if (is_wanted(rows_of(pair.a)) || is_wanted(rows_of(pair.b)))
        list(pair, features_of(pair.a), features_of(pair.b), visited);
    });
  }
  template <class IsWanted, class Take>
  void visit_with(const CollisionSurface& obstacle, const TriangleBvh& bvh,
                  const Eigen::Matrix3Xd& vertices, const IsWanted& is_wanted, const Take& take) {
    const std::vector<PatchAndNode>& leaves = leaves_with(bvh);
    visit_in_parts(leaves.size(), take, [&](std::size_t i, std::vector<FeaturePair>& visited) {
      const PatchAndNode& pair = leaves[i];
      if (is_wanted(rows_of(pair.patch)))
        features_of(pair.patch).list_with(boxed(obstacle, vertices, pair.node), visited);
    });
  }

 private:
  static constexpr std::size_t grain = 64;  // pairs of leaves in a part of what is listed
  static constexpr std::size_t parts_of(std::size_t count) { return (count + grain - 1) / grain; }

  // Blocks [first_row, end_row) x [first_column, end_column).
  struct Patch {
    int first_row = 0;
    int end_row = 0;
    int first_column = 0;
    int end_column = 0;
    int first_child = -1;  // -1: one block
    int second_child = -1;

    [[nodiscard]] bool is_leaf() const { return first_child < 0; }
    [[nodiscard]] int blocks() const { return (end_row - first_row) * (end_column - first_column); }
  };

  // The middle of a particle's range: x, y, z at its start and at its end.
  struct Middle {
    std::array<double, 6> at;
    double freedom_m;  // how far the particle may be beside its straight way
  };

  // What encloses edges along the ribbon and edges across it: x, y, z of their lowest and highest
  // ones at the start, then at the end.
  struct Tangents {
    std::array<double, 6> lowest_along;
    std::array<double, 6> highest_along;
    std::array<double, 6> lowest_across;
    std::array<double, 6> highest_across;
    double freedom_m;  // of a particle, at most

    void include(const Tangents& other);
    [[nodiscard]] Box along(int end) const;   // 0: at the start, 1: at the end
    [[nodiscard]] Box across(int end) const;  // likewise
  };

  // Is a patch with its margin flat? Found out when it is first asked for.
  enum class Flat : char { unknown, no, yes };

  struct PatchPair {
    int a = 0;  // a == b: the patch against itself
    int b = 0;
  };
  struct PatchAndNode {
    int patch = 0;
    int node = 0;  // of the obstacle's BVH
  };

  int build(Patch patch);
  void share_out();
  [[nodiscard]] int root() const { return static_cast<int>(patches_.size()) - 1; }
  [[nodiscard]] const Patch& at(int patch) const { return patches_[patch]; }
  [[nodiscard]] int block_number(int row, int column) const {
    return row * block_columns_ + column;
  }
  [[nodiscard]] int block_of(int leaf) const {
    return block_number(at(leaf).first_row, at(leaf).first_column);
  }
  // Of the block that has this quad.
  [[nodiscard]] int block_at(int quad_row, int quad_column) const {
    return block_number(quad_row / block_side, quad_column / block_side);
  }
  [[nodiscard]] Rows rows_of(int patch) const {
    return {block_side * at(patch).first_row,
            std::min(grid_.along - 1, block_side * at(patch).end_row)};
  }
  [[nodiscard]] int first_particle(int leaf) const {
    return grid_.particle(block_side * at(leaf).first_row, block_side * at(leaf).first_column);
  }
  [[nodiscard]] const BlockShape& shape_of(int leaf) const {
    const bool is_in_last_row = at(leaf).end_row == block_rows_;
    const bool is_in_last_column = at(leaf).end_column == block_columns_;
    return shapes_[(is_in_last_row ? 2 : 0) + (is_in_last_column ? 1 : 0)];
  }
  [[nodiscard]] BlockFeatures features_of(int leaf) const {
    return {shape_of(leaf), first_particle(leaf), vertices_, is_named_};
  }
  [[nodiscard]] ObstacleTriangle boxed(const CollisionSurface& obstacle,
                                       const Eigen::Matrix3Xd& vertices, int triangle) const;

  // Grown by half the reach, about the first particle, near which the others are.
  template <class AnyBox>
  [[nodiscard]] PackedBox packed(const AnyBox& box) const {
    return PackedBox::around(box, reach_m_ / 2, origin_);
  }
  void take_range(int particle, const MovingBox& range);
  void measure_edges(std::span<const MovingBox> ranges);
  [[nodiscard]] Tangents tangents_of_block(int block_row, int block_column) const;
  void widen_blocks(std::span<const int> rows);
  void join_blocks(std::span<const int> rows);
  [[nodiscard]] PackedBox box_of_leaf(int leaf) const;
  void refit_patch(int patch);
  void refit_patches();
  void look_only_at(std::span<const int> particles);
  [[nodiscard]] bool are_flat(const Tangents& tangents) const;
  [[nodiscard]] bool is_flat(int patch);
  [[nodiscard]] bool lie_flat(const PatchPair& pair);
  [[nodiscard]] bool stay_apart(const PatchPair& pair) const;
  [[nodiscard]] bool is_looked_at(int patch) const { return looked_at_[patch] != 0; }
  [[nodiscard]] bool can_meet(const PatchPair& pair);
  void split(const PatchPair& pair, std::vector<PatchPair>& next) const;

  const std::vector<PatchPair>& leaves_within();
  const std::vector<PatchAndNode>& leaves_with(const TriangleBvh& bvh);
  static void list(const PatchPair& pair, const BlockFeatures& of_a, const BlockFeatures& of_b,
                   std::vector<FeaturePair>& found) {
    if (pair.a == pair.b)
      of_a.list_within(found);
    else
      of_a.list_between(of_b, found);
  }
  template <class List>
  void list_in_parts(std::size_t count, const List& list, std::vector<FeaturePair>& found);
  // Takes what list(i, visited) lists for each i < count.
  template <class List, class Take>
  void visit_in_parts(std::size_t count, const Take& take, const List& list) {
    parts_.resize(std::max(parts_.size(), parts_of(count)));
    parallel_ranges(count, grain, [&](std::size_t begin, std::size_t end) {
      std::vector<FeaturePair>& visited = parts_[begin / grain];
      for (std::size_t i = begin; i < end; ++i) {
        visited.clear();
        list(i, visited);
        take(visited);
      }
    });
  }

  class RecentBlocks;

  RibbonGrid grid_;
  int block_rows_;
  int block_columns_;
  std::array<BlockShape, 4> shapes_;  // of blocks before the last row and column and in them
  std::vector<Patch> patches_;        // children before their parents; the root is last
  std::vector<int> branches_;         // roots of branches of some hundred patches, in order
  std::vector<int> trunk_;            // patches that are in no branch, in order
  double reach_m_ = 0;
  double along_m_ = 0;  // mean lengths of the edges at the start
  double across_m_ = 0;
  double apart_m_ = 0;  // at least, in the band, of two features that share no vertex
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  // of what is packed
  std::vector<PackedBox> vertices_;                   // grown by half the reach
  std::vector<Middle> middles_;                       // of the particles
  std::vector<char> is_named_;                        // is the particle one of those looked at?
  std::vector<PackedBox> boxes_;                      // of the patches
  std::vector<Tangents> tangents_;                    // of the patches with their margins
  std::vector<Flat> flat_;                            // are the patches with their margins?
  std::vector<char> looked_at_;                       // has the patch such a particle?
  std::vector<int> leaves_;                           // of the blocks
  std::vector<Tangents> widened_;  // of blocks and what lies beside them in the same row
  std::vector<int> changed_rows_;  // of blocks, that have a particle whose range has changed
  std::vector<int> stale_rows_;    // those and their margins
  std::vector<int> stale_before_;  // how many of these come before each row
  std::vector<char> has_changed_;  // scratch, for rows and for blocks
  BvhWalk<PatchPair, PatchPair> walk_within_;
  BvhWalk<PatchAndNode, PatchAndNode> walk_with_;
  std::vector<std::vector<FeaturePair>> parts_;  // of what is being listed or visited
};

}  // namespace ribbon

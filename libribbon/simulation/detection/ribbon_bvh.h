// A tree over rectangular patches of the ribbon that tells what lies too flat to meet itself.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "geometry/ribbon_grid.h"
#include "simulation/detection/block_features.h"
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
  // refit, pairs of blocks neither of which has one of them are left out.
  void refit_around(std::span<const int> particles, std::span<const MovingBox> ranges);

  // Pairs of features of the ribbon that share no vertex and may come within the reach of each
  // other, each once, in an order that depends on nothing but the ranges.
  [[nodiscard]] std::vector<FeaturePair> pairs_within() const;

  // Likewise, of the ribbon and of the still obstacle (3 x vertices), numbered after the particles.
  [[nodiscard]] std::vector<FeaturePair> pairs_with(const CollisionSurface& obstacle,
                                                    const TriangleBvh& bvh,
                                                    const Eigen::Matrix3Xd& vertices) const;

 private:
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

  // Of a patch with its margin.
  struct Tangents {
    MovingBox along;       // edges along the ribbon
    MovingBox across;      // edges across it
    double freedom_m = 0;  // how far a particle may be beside its straight way

    void include(const Tangents& other);
  };

  struct PatchPair {
    int a = 0;  // a == b: the patch against itself
    int b = 0;
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
  [[nodiscard]] BlockFeatures features_of(int leaf) const;

  [[nodiscard]] PackedBox packed(MovingBox range) const;
  void pack(std::span<const MovingBox> ranges);
  void measure_edges(std::span<const MovingBox> ranges);
  [[nodiscard]] Tangents tangents_of_block(std::span<const MovingBox> ranges, int block_row,
                                           int block_column) const;
  void widen_blocks(std::span<const MovingBox> ranges, std::span<const int> rows);
  void join_blocks(std::span<const int> rows);
  [[nodiscard]] PackedBox box_of_leaf(int leaf) const;
  void refit_patch(int patch);
  void refit_patches(const std::vector<char>& is_stale_row);
  void look_only_at(std::span<const int> particles);
  [[nodiscard]] bool is_flat(const Tangents& tangents) const;
  [[nodiscard]] bool lie_flat(const PatchPair& pair) const;
  [[nodiscard]] bool is_looked_at(int patch) const { return looked_at_[patch] != 0; }
  [[nodiscard]] bool can_meet(const PatchPair& pair) const;
  void split(const PatchPair& pair, std::vector<PatchPair>& next) const;
  void list(const PatchPair& pair, std::vector<FeaturePair>& found) const;

  RibbonGrid grid_;
  int block_rows_;
  int block_columns_;
  std::vector<Patch> patches_;  // children before their parents; the root is last
  std::vector<int> branches_;   // roots of branches of some hundred patches, in order
  std::vector<int> trunk_;      // patches that are in no branch, in order
  double reach_m_ = 0;
  double along_m_ = 0;  // mean lengths of the edges at the start
  double across_m_ = 0;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  // of what is packed
  std::vector<PackedBox> vertices_;                   // grown by half the reach
  std::vector<PackedBox> boxes_;                      // of the patches
  std::vector<Tangents> tangents_;                    // of the patches with their margins
  std::vector<char> flat_;                            // is the patch with its margin?
  std::vector<char> looked_at_;                       // has the patch such a particle?
  std::vector<Tangents> blocks_;                      // of single blocks, then with their margins
  std::vector<Tangents> widened_;  // of blocks and what lies beside them in the same row
};

}  // namespace ribbon

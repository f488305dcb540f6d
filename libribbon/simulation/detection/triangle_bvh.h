// The hierarchical object subdivision that spares redundant collision tests (paper, section 5.4.3).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "simulation/detection/candidate_pair.h"
#include "simulation/detection/collision_surface.h"

namespace ribbon {

// A tree over the triangles of one surface. Each leaf is a triangle; a region one level higher
// groups the three adjacent regions whose common contour is shortest. (Of more than eight triangles
// at one edge not all count as adjacent: all pairs of thousands would take hours.) The tree is
// built once; for each detection its boxes and, where they are asked for, its curvatures are
// refitted bottom-up, boxes by union and curvatures by bitwise and. A curvature has one bit for
// each of 14 directions: set while every normal of the region points that way. While one bit is
// left the region is too flat to meet itself.
class TriangleBvh {
 public:
  // What spares a pair of regions of one surface: `curvature_and_boxes` as published, or `boxes`
  // alone. Curvature spares much, but is blind to a band that lies flat over itself: its normals
  // all point one way although it has two layers. Where nothing may be missed, boxes decide.
  // Curvature must have been refitted since the boxes were.
  enum class Spare { curvature_and_boxes, boxes };

  // positions: 3 x at least all vertices that the surface uses; measures the contours.
  TriangleBvh(const CollisionSurface& surface, const Eigen::Matrix3Xd& positions);

  // Boxes over the ranges of the vertices (one box for each vertex that the surface uses), grown by
  // margin_m on every side. Forgets the curvatures.
  void refit(std::span<const MovingBox> ranges, double margin_m);

  // Curvatures at both ends of a step (3 x vertices each).
  void refit_curvatures(const Eigen::Matrix3Xd& t0, const Eigen::Matrix3Xd& t1);

  // Pairs of different triangles of this surface that may meet, in an order that depends on nothing
  // but the boxes and curvatures.
  [[nodiscard]] std::vector<CandidatePair> pairs_within(Spare spare) const;

  // Pairs (triangle of this surface, triangle of `other`) whose boxes meet.
  [[nodiscard]] std::vector<CandidatePair> pairs_with(const TriangleBvh& other) const;

  // The nodes, for who walks this tree against another: a leaf's number is its triangle's.
  [[nodiscard]] int node_count() const { return static_cast<int>(boxes_.size()); }
  [[nodiscard]] int root() const { return node_count() - 1; }
  [[nodiscard]] bool is_leaf(int node) const { return node < triangles_.cols(); }
  [[nodiscard]] const MovingBox& box(int node) const { return boxes_[node]; }
  [[nodiscard]] std::span<const int> children(int node) const {
    const int first = first_child_[node];
    const int last = first_child_[node + 1];
    return std::span(children_).subspan(first, last - first);
  }

 private:
  struct NodePair {
    int a = 0;  // a == b: the region against itself
    int b = 0;
  };

  void measure_borders(std::size_t vertices);
  [[nodiscard]] bool adjacent(int a, int b) const;
  [[nodiscard]] bool can_meet(const NodePair& pair, Spare spare) const;
  void descend(const NodePair& pair, std::vector<NodePair>& next) const;
  template <class Node, class Join>
  void refit_inner(std::vector<Node>& nodes, const Join& join) const;
  static void descend(const TriangleBvh& first, const TriangleBvh& second, const NodePair& pair,
                      std::vector<NodePair>& next);

  Eigen::Matrix3Xi triangles_;
  // Nodes 0 ... triangles-1 are the leaves; children come before their parents; the root is last.
  // From this node on, nodes join pieces that nothing connects; no curvature spares those.
  int first_joining_node_ = 0;
  std::vector<int> first_child_;   // into children_, one more than nodes
  std::vector<int> children_;      // of all inner nodes, one after the other
  std::vector<int> first_border_;  // into border_, one more than nodes
  std::vector<int> border_;        // vertices that a region shares with others, sorted per region
  std::vector<MovingBox> boxes_;
  std::vector<std::uint32_t> curvatures_;
};

}  // namespace ribbon

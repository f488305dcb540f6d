// The features of a block of two by two quads of the ribbon, and the pairs of them that come close.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "geometry/ribbon_grid.h"
#include "simulation/detection/collision_surface.h"
#include "simulation/detection/feature_pairs.h"

namespace ribbon {

inline constexpr int block_side = 2;  // quads

// A feature of n vertices.
template <std::size_t n>
struct BoxedFeature {
  std::array<int, n> vertices;
  bool is_looked_at;
  PackedBox box;
};

// A triangle of the obstacle's surface, with the features for which it answers.
struct ObstacleTriangle {
  // first_vertex: the number of the surface's first vertex. corners: the boxes of the triangle's,
  // each grown by half of the distance at which pairs are wanted.
  ObstacleTriangle(const CollisionSurface& surface, int first_vertex, int triangle,
                   const std::array<PackedBox, 3>& corners);

  BoxedFeature<3> whole;
  std::array<BoxedFeature<1>, 3> vertices;
  std::array<BoxedFeature<2>, 3> edges;
  std::array<bool, 3> answers_for_vertex;
  std::array<bool, 3> answers_for_edge;
};

// At most so many of a kind; no memory is taken.
template <class Element, std::size_t most>
class ShortList {
 public:
  Element& add() { return elements_[count_++]; }
  [[nodiscard]] std::span<const Element> all() const { return std::span(elements_).first(count_); }

 private:
  std::array<Element, most> elements_;
  std::size_t count_ = 0;
};

// At most of a block.
inline constexpr std::size_t quads_of_block = std::size_t{block_side} * block_side;
inline constexpr std::size_t particles_of_block = std::size_t{block_side + 1} * (block_side + 1);
inline constexpr std::size_t edges_of_block =
    std::size_t{2} * block_side * (block_side + 1) + quads_of_block;

// Which features a block has, their vertices counted from its first particle on. Particles and
// edges that blocks share belong to one of them, so that a pair of features is listed once.
struct BlockShape {
  // Of the block that begins at quad (block_side * row, block_side * column) of the grid. Blocks
  // that do not lie at the grid's end have the same.
  BlockShape(const RibbonGrid& grid, int row, int column);

  ShortList<std::array<int, 1>, particles_of_block> particles;  // all of the block
  ShortList<std::array<int, 1>, particles_of_block> vertices;   // for which it answers
  ShortList<std::array<int, 2>, edges_of_block> edges;          // likewise
  ShortList<std::array<int, 3>, 2 * quads_of_block> triangles;
};

class BlockFeatures {
 public:
  // Of no block.
  BlockFeatures() = default;

  // boxes: of all vertices, each grown by half of the distance at which pairs are wanted. Pairs of
  // which no vertex is looked at (one flag for each) are left out.
  BlockFeatures(const BlockShape& shape, int first_particle, std::span<const PackedBox> boxes,
                std::span<const char> is_looked_at);

  // Append the pairs of features that share no vertex and whose boxes meet: within the block, and
  // between it and another.
  void list_within(std::vector<FeaturePair>& found) const;
  void list_between(const BlockFeatures& other, std::vector<FeaturePair>& found) const;
  void list_with(const ObstacleTriangle& of_obstacle, std::vector<FeaturePair>& found) const;

 private:
  ShortList<BoxedFeature<1>, particles_of_block> vertices_;  // for which the block answers
  ShortList<BoxedFeature<2>, edges_of_block> edges_;         // likewise
  ShortList<BoxedFeature<3>, 2 * quads_of_block> triangles_;
  PackedBox box_;  // of all of it
};

}  // namespace ribbon

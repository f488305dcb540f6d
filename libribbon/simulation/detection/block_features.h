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
  PackedBox box;
};

// Particles and edges that blocks share belong to one of them, so that a pair of features is listed
// once.
class BlockFeatures {
 public:
  // The block that begins at quad (block_side * row, block_side * column) of the grid. boxes: of
  // all vertices, each grown by half of the distance at which pairs are wanted.
  BlockFeatures(const RibbonGrid& grid, int row, int column, std::span<const PackedBox> boxes);

  // Append the pairs of features that share no vertex and whose boxes meet: within the block, and
  // between it and another.
  void list_within(std::vector<FeaturePair>& found) const;
  void list_between(const BlockFeatures& other, std::vector<FeaturePair>& found) const;

  // Likewise, with the features for which a triangle of the obstacle's surface answers, whose first
  // vertex has this number. corners: the boxes of the triangle's, grown as above.
  void list_with(const CollisionSurface& obstacle, int first_vertex, int triangle,
                 const std::array<PackedBox, 3>& corners, std::vector<FeaturePair>& found) const;

 private:
  // At most so many features of a kind; no memory is taken.
  template <std::size_t n, std::size_t most>
  class List {
   public:
    void add(const BoxedFeature<n>& feature) { features_[count_++] = feature; }
    [[nodiscard]] std::span<const BoxedFeature<n>> all() const {
      return std::span(features_).first(count_);
    }

   private:
    std::array<BoxedFeature<n>, most> features_;
    std::size_t count_ = 0;
  };
  static constexpr std::size_t quads = std::size_t{block_side} * block_side;
  static constexpr std::size_t particles = std::size_t{block_side + 1} * (block_side + 1);
  static constexpr std::size_t sides = std::size_t{2} * block_side * (block_side + 1);

  void add_quad(const RibbonGrid& grid, int row, int column, std::span<const PackedBox> boxes);

  List<1, particles> vertices_;   // for which the block answers
  List<2, sides + quads> edges_;  // likewise
  List<3, 2 * quads> triangles_;  // of the block
  PackedBox box_;                 // of all of it
};

}  // namespace ribbon

// Which pairs of features each particle belongs to.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "simulation/detection/feature_pairs.h"

namespace ribbon {

// Keeps its memory from one list of pairs to the next.
class PairsOfParticles {
 public:
  // Of particles [0, particles); other vertices are the obstacle's.
  void sort(std::span<const FeaturePair> pairs, int particles);

  // Indices of a particle's pairs, in order.
  [[nodiscard]] std::span<const std::size_t> operator[](int particle) const {
    return {indices_.data() + begins_[particle], indices_.data() + begins_[particle + 1]};
  }

 private:
  std::vector<std::size_t> begins_;   // in the indices, of the particles; at last their number
  std::vector<std::size_t> indices_;  // of all particles' pairs, one particle after the other
};

}  // namespace ribbon

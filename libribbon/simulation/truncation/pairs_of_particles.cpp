#include "simulation/truncation/pairs_of_particles.h"

#include <numeric>

namespace ribbon {

// Counted, then filled from behind: each begin moves from its particle's end to its begin.
void PairsOfParticles::sort(std::span<const FeaturePair> pairs, int particles) {
  begins_.assign(static_cast<std::size_t>(particles) + 1, 0);
  for (const FeaturePair& pair : pairs)
    for (const int vertex : pair.vertices)
      if (vertex < particles) ++begins_[vertex];
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  indices_.resize(begins_.back());
  for (std::size_t i = pairs.size(); i-- > 0;)
    for (const int vertex : pairs[i].vertices)
      if (vertex < particles) indices_[--begins_[vertex]] = i;
}

}  // namespace ribbon

#include "simulation/contact/collision_response.h"

#include <optional>

#include "simulation/contact/collision.h"

namespace ribbon {

bool repel_once(std::span<const FeaturePair> pairs, const PairGaps& gaps,
                const RepulsionSettings& settings, const Eigen::Matrix3Xd& before, Cloth& cloth) {
  bool any = false;
  for (const FeaturePair& pair : pairs) {
    // Earlier repulsions of this round count: each pair is tested where its vertices are by now.
    const double gap_m = gaps.contact_m(pair);
    const std::optional<Collision> collision = find_collision(pair, before, cloth.positions, gap_m);
    if (!collision) continue;
    repel(pair, *collision, gap_m, settings, before, cloth);
    any = true;
  }
  return any;
}

}  // namespace ribbon

#include "simulation/collision_response.h"

#include <optional>

#include "simulation/collision.h"
#include "simulation/repulsion.h"
#include "simulation/swept_pairs.h"

namespace ribbon {

namespace {

// Repels every pair that collides; was there one?
bool repel_once(Bodies& bodies, const ContactSettings& settings, Hierarchy::Spare spare,
                const Eigen::Matrix3Xd& before, Cloth& cloth) {
  bool any = false;
  for (const FeaturePair& pair :
       swept_pairs(bodies, spare, before, cloth.positions, settings.gap_m)) {
    // Earlier repulsions of this round count: each pair is tested where its vertices are by now.
    const std::optional<Collision> collision =
        find_collision(pair, before, cloth.positions, settings.gap_m);
    if (!collision) continue;
    repel(pair, *collision, settings.gap_m, settings.restitution, cloth);
    any = true;
  }
  return any;
}

}  // namespace

void repel_collisions(Bodies& bodies, const ContactSettings& settings, Hierarchy::Spare spare,
                      const Eigen::Matrix3Xd& before, Cloth& cloth) {
  for (int round = 0; round < settings.rounds; ++round)
    if (!repel_once(bodies, settings, spare, before, cloth)) return;
}

}  // namespace ribbon

// How the tree over the ribbon's triangles follows its motion.
#pragma once

#include "player/render/quality.h"

namespace ribbon {

// What rays meet does not depend on it, only how long that takes.
enum class RibbonTree {
  rebuilt,  // anew for each frame: rays find their way fastest
  refitted  // that of the first frame, its boxes grown and shrunk: an eighth of the time to set up
};

// Where a pixel has one ray and one to the sun, rebuilding takes longer than what it saves them.
constexpr RibbonTree worthwhile_tree(const Quality& quality) {
  return quality.sky == SkyLight::open ? RibbonTree::refitted : RibbonTree::rebuilt;
}

}  // namespace ribbon

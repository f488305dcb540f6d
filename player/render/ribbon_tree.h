// How the tree over the ribbon's triangles follows its motion.
#pragma once

#include "player/render/quality.h"

namespace ribbon {

enum class RibbonTree {
  rebuilt,  // anew: rays find their way fastest
  refitted  // the one before, its boxes grown and shrunk: a sixth of the time
};

// For how many frames a tree is worth keeping: the fewer rays a pixel has, the less they lose on
// their way through an older one.
constexpr int frames_a_tree_lasts(const Quality& quality) {
  if (quality.sky == SkyLight::open) return 64;
  return quality.sky == SkyLight::occluded ? 8 : 1;
}

// Where the tree of frame `index` was built. It decides which of two triangles is met where both
// are as near, on the edge between them: so it must not depend on which frames are shown before.
constexpr int frame_of_tree(int index, const Quality& quality) {
  return index - index % frames_a_tree_lasts(quality);
}

}  // namespace ribbon

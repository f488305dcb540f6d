// One ribbon, and what a scene can ask for added one by one.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace ribbon {

struct FeatureScene {
  std::string feature;  // what this scene has besides what the one before has
  Scene scene;
};

// From `full`, which has springs, air, an obstacle and a fastening: first nothing of it, then one
// feature after the other until all are there, then other choices, each made in the full scene. One
// with a width profile is of another ribbon, which has to be drawn.
std::vector<FeatureScene> feature_scenes(const Scene& full);

}  // namespace ribbon

// Scenes at the extremes: one small fastening whose numbers are taken to their limits, one at a
// time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"

namespace ribbon {

struct ExtremeScene {
  std::string extreme;  // what is extreme about it
  Scene scene;
  RibbonMesh mesh;
  std::optional<TriangleMesh> obstacle;
  int steps = 200;
};

// The loop of tests/simulation/loop_scene.h, 3 particles across and 80 along, drawn tight on its
// post, with one extreme each; sizes up to so many particles.
std::vector<ExtremeScene> extreme_scenes(int most_particles);

}  // namespace ribbon

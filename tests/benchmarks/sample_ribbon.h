// The ribbon and the object of a scene, ready to be simulated; of a sample in any granularity.
#pragma once

#include <filesystem>
#include <optional>

#include "geometry/triangle_mesh.h"
#include "result/result.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"

namespace ribbon {

struct SampleRibbon {
  Scene scene;
  RibbonMesh mesh;
  std::optional<TriangleMesh> obstacle;
};

Result<SampleRibbon> ribbon_of(const Scene& scene);

// With along x across particles and springs that resist lengthwise as the sample's do: across times
// resistance over along stays the same.
Result<SampleRibbon> sample_ribbon(const std::filesystem::path& scene_file, int along, int across);

}  // namespace ribbon

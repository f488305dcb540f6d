#include "benchmarks/sample_ribbon.h"

#include <utility>

#include "obstacle/obstacle.h"

namespace ribbon {

namespace {

void refine(Scene& scene, int along, int across) {
  const double stiffer = static_cast<double>(scene.ribbon.across) / across *
                         static_cast<double>(along) / scene.ribbon.along;
  for (double* resistance : {&scene.springs.stretch, &scene.springs.shear, &scene.springs.bend})
    *resistance *= stiffer;
  scene.ribbon.along = along;
  scene.ribbon.across = across;
}

}  // namespace

Result<SampleRibbon> ribbon_of(const Scene& scene) {
  auto obstacle = read_obstacle(scene);
  if (!obstacle) return tl::unexpected(obstacle.error());
  auto ribbon = draw_ribbon(scene, *obstacle);
  if (!ribbon) return tl::unexpected(ribbon.error());
  return SampleRibbon{scene, *std::move(ribbon), *std::move(obstacle)};
}

Result<SampleRibbon> sample_ribbon(const std::filesystem::path& scene_file, int along, int across) {
  auto scene = read_scene(scene_file);
  if (!scene) return tl::unexpected(scene.error());
  refine(*scene, along, across);
  return ribbon_of(*scene);
}

}  // namespace ribbon

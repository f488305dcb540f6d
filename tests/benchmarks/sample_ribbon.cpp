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

Result<SampleRibbon> ribbon_of(const Scene& scene, TightPassage tight) {
  const auto curve =
      generate_space_curve(scene.curve, scene.ribbon.width_m, scene.ribbon.along, tight);
  if (!curve) return tl::unexpected(curve.error());
  SampleRibbon ribbon{scene, generate_ribbon_mesh(*curve, scene.ribbon, scene.curve.axis),
                      std::nullopt};
  if (!scene.obstacle) return ribbon;
  auto obstacle = read_obstacle(*scene.obstacle);
  if (!obstacle) return tl::unexpected(obstacle.error());
  ribbon.obstacle = std::move(*obstacle);
  return ribbon;
}

Result<SampleRibbon> sample_ribbon(const std::filesystem::path& scene_file, int along, int across) {
  auto scene = read_scene(scene_file);
  if (!scene) return tl::unexpected(scene.error());
  refine(*scene, along, across);
  return ribbon_of(*scene);
}

}  // namespace ribbon

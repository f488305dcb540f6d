#include "benchmarks/sample_ribbon.h"

#include <utility>

#include "curve/space_curve.h"
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

Result<SampleRibbon> sample_ribbon(const std::filesystem::path& scene_file, int along, int across) {
  auto scene = read_scene(scene_file);
  if (!scene) return tl::unexpected(scene.error());
  refine(*scene, along, across);
  const auto curve = generate_space_curve(scene->curve, scene->ribbon.width_m, along);
  if (!curve) return tl::unexpected(curve.error());
  SampleRibbon sample{*scene, generate_ribbon_mesh(*curve, scene->ribbon, scene->curve.axis),
                      std::nullopt};
  if (sample.scene.obstacle) {
    auto obstacle = read_obstacle(*sample.scene.obstacle);
    if (!obstacle) return tl::unexpected(obstacle.error());
    sample.obstacle = std::move(*obstacle);
  }
  return sample;
}

}  // namespace ribbon

// A band laid once round the axis, its ends passing each other in front: it is drawn tight on
// whatever stands on the axis.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/triangle_mesh.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "scene/scene.h"

namespace ribbon {

inline constexpr double loop_radius_m = 0.5;

// `size` scales all lengths.
inline SpaceCurve loop(int samples, double size = 1) {
  SpaceCurve curve;
  curve.points.resize(3, samples);
  for (int i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / (samples - 1);
    const double angle = 2.6 * std::numbers::pi * (t - 0.5);
    curve.points.col(i) << loop_radius_m * std::sin(angle), 0.16 * (t - 0.5),
        -loop_radius_m * std::cos(angle);
  }
  curve.points *= size;
  curve.length_m = size * std::hypot(loop_radius_m * 2.6 * std::numbers::pi, 0.16);
  return curve;
}

inline Scene scene_of_loop() {
  Scene scene;
  scene.name = "loop";
  scene.ribbon = {.width_m = 0.06, .along = 120, .across = 4, .mass_kg = 0.3};
  scene.springs = {.stretch = 10, .shear = 10, .bend = 10};
  scene.air_resistance_per_s = 4;
  scene.fastening = FasteningScene{.speed_m_s = 0.4};
  scene.time = {.step_s = 0.01, .duration_s = 1};
  return scene;
}

inline RibbonMesh mesh_of_loop(const Scene& scene, double size = 1) {
  return generate_ribbon_mesh(loop(scene.ribbon.along, size), scene.ribbon, Axis::y);
}

// A tube round the axis, open at both ends, its outside outwards.
inline TriangleMesh post(double radius_m, int sides = 24) {
  const int rims = 2 * sides;
  TriangleMesh mesh;
  mesh.name = "post";
  mesh.vertices.resize(3, rims);
  mesh.triangles.resize(3, rims);
  for (int s = 0; s < sides; ++s) {
    const double angle = 2 * std::numbers::pi * s / sides;
    const int low = 2 * s;
    const int next = 2 * ((s + 1) % sides);
    for (int end = 0; end < 2; ++end)
      mesh.vertices.col(low + end) << static_cast<float>(radius_m * std::sin(angle)),
          end == 0 ? -0.6F : 0.6F, static_cast<float>(radius_m * std::cos(angle));
    mesh.triangles.col(low) << low, next, next + 1;
    mesh.triangles.col(low + 1) << low, next + 1, low + 1;
  }
  return mesh;
}

}  // namespace ribbon

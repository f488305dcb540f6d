// A band laid once round the axis, its ends passing each other in front: it is drawn tight on
// whatever stands on the axis.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/solids.h"
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
  scene.fastening = FasteningScene{.speed_m_s = 0.4, .yield_strain = unyielding};
  scene.time = {.step_s = 0.01, .duration_s = 1};
  scene.recording.max_position_error = 1e-5;
  return scene;
}

// From a third of its width to five thirds.
inline RibbonScene with_profile(RibbonScene ribbon) {
  ribbon.profile = WidthProfile{{{0, ribbon.width_m / 3}, {1, ribbon.width_m * 5 / 3}}};
  return ribbon;
}

inline RibbonMesh mesh_of_loop(const Scene& scene, double size = 1) {
  return generate_ribbon_mesh(loop(scene.ribbon.along, size), scene.ribbon, Axis::y);
}

// With fewer particles, where there are many runs.
inline Scene scene_of_small_loop() {
  Scene scene = scene_of_loop();
  scene.ribbon.along = 80;
  scene.ribbon.across = 3;
  return scene;
}

// A straight band along x, which begins at `begin`.
inline SpaceCurve straight_curve(int samples, double length_m,
                                 const Eigen::Vector3d& begin = Eigen::Vector3d::Zero()) {
  SpaceCurve curve;
  curve.points = begin.replicate(1, samples);
  curve.points.row(0) += Eigen::RowVectorXd::LinSpaced(samples, 0, length_m);
  curve.length_m = length_m;
  return curve;
}

// Two rows are no loop: they stand as a straight band beside the axis.
inline RibbonMesh mesh_of_four_particles(Scene& scene) {
  scene.ribbon.along = 2;
  scene.ribbon.across = 2;
  return generate_ribbon_mesh(straight_curve(2, 0.1, {0, 0.5, 0}), scene.ribbon, Axis::y);
}

// A tube round the axis, open at both ends, its outside outwards.
inline TriangleMesh post(double radius_m, int sides = 24) {
  return tube(radius_m, -0.6, 0.6, sides);
}

}  // namespace ribbon

// A small recording that holds what trips exporters up: vertices that coincide, a frame equal to
// the first, coordinates far from the origin, an obstacle whose name has a space.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "recording/records/recording.h"

namespace ribbon {

struct SampleKnot {
  RecordingHeader header;
  std::vector<Eigen::Matrix3Xd> frames;  // metres
};

inline TriangleMesh sample_obstacle(const Eigen::Vector3f& origin) {
  TriangleMesh mesh{.name = "small object",
                    .vertices = Eigen::Matrix3Xf(3, 5),
                    .triangles = Eigen::Matrix3Xi(3, 6)};
  mesh.vertices << 0, 0.3F, 0.1F, 0.1F, 0.15F,  //
      0, 0, 0, 0.4F, -0.3F,                     //
      0, 0, 0.2F, 0.1F, 0.1F;
  mesh.vertices.colwise() += origin;
  mesh.triangles << 0, 1, 2, 1, 2, 0,  //
      3, 3, 3, 0, 1, 2,                //
      1, 2, 0, 4, 4, 4;
  return mesh;
}

inline Eigen::Matrix2Xf sample_uv(const RibbonGrid& grid) {
  Eigen::Matrix2Xf uv(2, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p)
    uv.col(p) << static_cast<float>(grid.row(p)) / static_cast<float>(grid.along - 1),
        static_cast<float>(grid.column(p)) / static_cast<float>(grid.across - 1);
  return uv;
}

inline Eigen::Matrix3Xd sample_wave(const RibbonGrid& grid, double phase) {
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const int i = grid.row(p);
    const int j = grid.column(p);
    positions.col(p) << 0.1 * i, 0.05 * std::sin(i + phase) + 0.3, 0.03 * j + 0.02 * phase;
  }
  return positions;
}

// Five frames: rest, a wave, one with two pinched rows and a closed loop, the rest again, a wave.
inline SampleKnot sample_knot(RibbonGrid grid = {.along = 12, .across = 4},
                              const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) {
  SampleKnot knot;
  knot.header.scene_name = "first knot";
  knot.header.scene_text = "[ribbon]\n";
  knot.header.writer = "test";
  knot.header.grid = grid;
  knot.header.uv = sample_uv(grid);
  knot.header.ribbon_length_m = 0.1 * (grid.along - 1);
  knot.header.ribbon_width_m = 0.03 * (grid.across - 1);
  knot.header.frames_per_second = 50;
  // Single precision cannot keep the usual bound a kilometre away.
  knot.header.max_position_error_m = 1e-5 * knot.header.ribbon_length_m + 1e-6 * origin.norm();
  knot.header.quantisation_step_m = quantisation_step_m(
      knot.header.max_position_error_m, origin.norm() + knot.header.ribbon_length_m);
  knot.header.obstacle = sample_obstacle(origin.cast<float>());
  for (const double phase : {0.0, 0.7, 1.4, 0.0, 2.1})
    knot.frames.emplace_back(sample_wave(grid, phase).colwise() + origin);
  Eigen::Matrix3Xd& pinched = knot.frames[2];
  for (const int row : {0, grid.along / 2})
    for (int j = 1; j < grid.across; ++j)
      pinched.col(grid.particle(row, j)) = pinched.col(grid.particle(row, 0));
  for (int j = 0; j < grid.across; ++j)
    pinched.col(grid.particle(grid.along - 1, j)) = pinched.col(grid.particle(0, j));
  return knot;
}

}  // namespace ribbon

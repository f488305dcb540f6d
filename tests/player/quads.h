// Small scenes whose light can be worked out by hand.
#pragma once

#include <Eigen/Core>

#include "player/render/surface.h"
#include "recording/records/recording.h"

namespace ribbon::test {

// A ribbon of one quad, 4 m long and 1 m wide.
inline RecordingHeader quad_ribbon() {
  RecordingHeader header;
  header.scene_name = "one quad";
  header.grid = {2, 2};
  header.uv.resize(2, 4);
  header.uv << 0, 0, 1, 1, 0, 1, 0, 1;
  header.ribbon_length_m = 4;
  header.ribbon_width_m = 1;
  return header;
}

// Its particles in the plane z = 0, around the origin, along x, front to +z.
inline Eigen::Matrix3Xf flat_quad() {
  Eigen::Matrix3Xf positions(3, 4);
  positions << -2, -2, 2, 2, -0.5F, 0.5F, -0.5F, 0.5F, 0, 0, 0, 0;
  return positions;
}

// What is drawn of a ribbon of one quad whose particles are there.
inline Surface quad_surface(const Eigen::Matrix3Xf& positions) {
  const RecordingHeader header = quad_ribbon();
  Surface ribbon = ribbon_surface(header.grid);
  update_ribbon(header.grid, positions, ribbon);
  return ribbon;
}

}  // namespace ribbon::test

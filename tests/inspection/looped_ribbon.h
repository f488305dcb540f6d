// A ribbon with a loop, and a post to slip off.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

#include "geometry/solids.h"
#include "recording/sample_recording.h"

namespace ribbon {

inline constexpr double loop_width_m = 0.02;
inline const CentreAxis upright{{0, 0, 0}, {0, 1, 0}};
inline const TriangleMesh object = closed(tube(0.05, -0.3, 0.3));

struct Pose {
  double height_m = 0;  // of the loop
  double slant = 0;     // metres up per metre along x
  double x_m = 0;       // of its middle
  double turns = 1;
};

// Comes from afar, goes round a circle of radius 0.07, a little higher each time, and away again.
inline Eigen::Matrix3Xd looped(const Pose& pose, int count = 400) {
  constexpr double radius_m = 0.07;
  constexpr double tail_m = 0.5;
  const double loop_m = 2 * std::numbers::pi * radius_m * pose.turns;
  Eigen::Matrix3Xd curve(3, count);
  for (int k = 0; k < count; ++k) {
    const double way_m = (loop_m + 2 * tail_m) * k / (count - 1) - tail_m;
    const double on_loop_m = std::clamp(way_m, 0.0, loop_m);
    const double angle = on_loop_m / radius_m;
    const Eigen::Vector3d out(std::sin(angle), 0, std::cos(angle));
    const Eigen::Vector3d ahead(std::cos(angle), 0, -std::sin(angle));
    Eigen::Vector3d point = radius_m * out + (way_m - on_loop_m) * ahead;
    point += Eigen::Vector3d(pose.x_m, pose.height_m + pose.slant * point.x() + 0.001 * angle, 0);
    curve.col(k) = point;
  }
  return curve;
}

inline RecordingHeader header_with_post() {
  RecordingHeader header = sample_header();
  header.grid = {200, 2};
  header.uv.setZero(2, header.grid.particle_count());
  header.ribbon_length_m = 1.4;
  header.ribbon_width_m = loop_width_m;
  header.stated_gap_m = 0;
  header.centre_axis = upright;
  header.obstacle = object;
  return header;
}

// 3 x particles of that header's ribbon, lying flat.
inline Eigen::Matrix3Xd looped_ribbon(const RecordingHeader& header, const Pose& pose) {
  const RibbonGrid& grid = header.grid;
  const Eigen::Matrix3Xd line = looped(pose, grid.along);
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int i = 0; i < grid.along; ++i) {
    const int next = std::min(i + 1, grid.along - 1);
    const Eigen::Vector3d ahead = line.col(next) - line.col(next - 1);
    const Eigen::Vector3d out = ahead.cross(Eigen::Vector3d::UnitY()).normalized();
    for (int j = 0; j < grid.across; ++j)
      positions.col(grid.particle(i, j)) = line.col(i) + (j - 0.5) * loop_width_m * out;
  }
  return positions;
}

// One frame per pose; the file's path.
inline std::filesystem::path record_loops(const RecordingHeader& header,
                                          const std::vector<Pose>& poses) {
  std::vector<Eigen::Matrix3Xd> frames;
  frames.reserve(poses.size());
  for (const Pose& pose : poses) frames.push_back(looped_ribbon(header, pose));
  auto path = temporary_file("loops.rbn");
  std::filesystem::remove(path);
  write_recording(path, header, frames);
  return path;
}

}  // namespace ribbon

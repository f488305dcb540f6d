// What a recording holds; FORMAT.md says how it lies in the file.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "geometry/centre_axis.h"
#include "geometry/ribbon_grid.h"
#include "geometry/triangle_mesh.h"

namespace ribbon {

// Everything about a recording that does not change from frame to frame.
struct RecordingHeader {
  std::string scene_name;  // never empty
  std::string scene_text;  // the scene's TOML
  std::string writer;      // program and version that wrote it
  RibbonGrid grid;
  Eigen::Matrix2Xf uv;  // 2 x particles, u along and v across, both from 0 to 1
  double ribbon_length_m = 0;
  double ribbon_width_m = 0;
  double frames_per_second = 0;
  double max_position_error_m = 0;  // bound on every recorded coordinate; > 0
  std::optional<TriangleMesh> obstacle;
  // The writer guarantees that features that share no vertex (ribbon and ribbon, ribbon and
  // obstacle) are nowhere nearer to each other, in frames as they are decoded. 0: nothing is
  // stated.
  double stated_gap_m = 0;
  std::optional<CentreAxis> centre_axis;  // what the ribbon was fastened towards
};

// The numbers of one frame, readable without its geometry.
struct FrameNumbers {
  double time_s = 0;
  double worst_strain = 0;  // largest |length / rest length - 1| of stretch and shear springs
  std::uint32_t penetrating_edges = 0;    // left over in this frame
  std::uint32_t recovery_iterations = 0;  // of Figure 15, summed over the steps since the last
                                          // frame
  bool operator==(const FrameNumbers&) const = default;
};

}  // namespace ribbon

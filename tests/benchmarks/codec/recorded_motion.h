// The motion that a recording holds, as the truth that other recordings of it are compared with.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "recording/records/recording.h"
#include "result/result.h"

namespace ribbon {

struct RecordedMotion {
  RecordingHeader header;
  std::vector<FrameNumbers> numbers;     // of each frame
  std::vector<Eigen::Matrix3Xf> frames;  // 3 x particles each, metres

  [[nodiscard]] double largest_m() const;                          // of all coordinates
  [[nodiscard]] double start_m() const;                            // of those of the first frame
  [[nodiscard]] double quantisation_step_m(double bound_m) const;  // that a recorder would choose
};

// All frames of a recording; fails where one cannot be read.
Result<RecordedMotion> read_motion(const std::filesystem::path& path);

}  // namespace ribbon

// The motion that a recording holds, as the truth that other recordings of it are compared with.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "recording/recording.h"
#include "result/result.h"

namespace ribbon {

struct RecordedMotion {
  RecordingHeader header;
  std::vector<FrameNumbers> numbers;     // of each frame
  std::vector<Eigen::Matrix3Xf> frames;  // 3 x particles each, metres

  [[nodiscard]] double largest_m() const;  // of all coordinates
  // What the recorder takes for that before it knows: any point of the start drawn away by the
  // ribbon's length.
  [[nodiscard]] double reach_m() const;
};

// All frames of a recording; fails where one cannot be read.
Result<RecordedMotion> read_motion(const std::filesystem::path& path);

}  // namespace ribbon

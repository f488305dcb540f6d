// All that a recording tells of its frames.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <vector>

#include "playback/recording_reader.h"

namespace ribbon {

struct PlayedFrame {
  std::optional<FrameNumbers> numbers;
  Eigen::Matrix3Xf positions;  // without columns where the frame cannot be read

  bool operator==(const PlayedFrame& other) const {
    return numbers == other.numbers && positions.cols() == other.positions.cols() &&
           positions == other.positions;
  }
};

inline std::vector<PlayedFrame> frames_of(RecordingReader& reader) {
  std::vector<PlayedFrame> frames(reader.frame_count());
  for (int index = 0; index < reader.frame_count(); ++index) {
    PlayedFrame& frame = frames[index];
    frame.numbers = reader.numbers(index);
    if (!reader.read(index, frame.positions)) frame.positions.resize(3, 0);
  }
  return frames;
}

inline std::vector<PlayedFrame> frames_of(const std::filesystem::path& recording) {
  auto reader = RecordingReader::open(recording).value();
  return frames_of(reader);
}

// The first of `frames` that is not as in `expected` (an index, or the number of frames where there
// are more), -1 where all are; `expected` may go on.
inline int first_difference(const std::vector<PlayedFrame>& frames,
                            const std::vector<PlayedFrame>& expected) {
  for (std::size_t index = 0; index < frames.size(); ++index)
    if (index >= expected.size() || !(frames[index] == expected[index]))
      return static_cast<int>(index);
  return -1;
}

}  // namespace ribbon

// A fastening processor as a source of frames.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "recording/records/recording.h"
#include "scene/scene.h"
#include "simulation/fastening_processor.h"

namespace ribbon {

struct SimulatedFrame {
  int index = 0;  // from 0
  FrameNumbers numbers;
  Eigen::Matrix3Xd positions;  // 3 x particles, metres
};

// A frame is taken at the first step at or after its time.
class SimulatedFrames {
 public:
  // Wall time and steps so far.
  struct Effort {
    double simulation_s = 0;
    double measuring_s = 0;  // of the numbers
    std::int64_t steps = 0;
  };

  // `fastening` stands where frame `index` was taken; -1: at its start, of which no frame has been
  // taken yet.
  SimulatedFrames(const Scene& scene, FasteningProcessor fastening, int index);

  // The index of the last frame.
  [[nodiscard]] int index() const { return index_; }
  // Steps on to the next frame.
  SimulatedFrame next();

  [[nodiscard]] double frames_per_second() const { return frames_per_second_; }
  [[nodiscard]] FasteningProcessor& fastening() { return fastening_; }
  [[nodiscard]] const Effort& effort() const { return effort_; }

 private:
  FasteningProcessor fastening_;
  double frames_per_second_;
  int index_;
  Effort effort_;
};

}  // namespace ribbon

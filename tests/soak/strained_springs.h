// How many springs of a recorded ribbon are stretched or shrunk too far.
#pragma once

#include <cstddef>

#include "playback/recording_reader.h"
#include "result/result.h"

namespace ribbon {

struct StrainedSprings {
  std::size_t springs = 0;    // of the ribbon: stretch and shear
  double limit = 0;           // elongation or shrinking, of the rest length
  double worst_share = 0;     // of the springs beyond the limit, in the frame that has most of them
  int worst_share_frame = 0;  // from 1
  double mean_share = 0;      // over all frames
  double last_share = 0;      // in the last frame
  double worst_elongation = 0;  // of any spring in any frame
  int worst_frame = 0;          // from 1
};

// Decodes all frames. Fails where one cannot be read.
Result<StrainedSprings> strained_springs(RecordingReader& recording, double limit);

}  // namespace ribbon

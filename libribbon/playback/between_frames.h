// Positions between the frames of a recording.
#pragma once

#include <Eigen/Core>
#include <array>

#include "playback/recording_reader.h"
#include "result/result.h"

namespace ribbon {

class BetweenFrames {
 public:
  // Keeps a reference to `reader`.
  explicit BetweenFrames(RecordingReader& reader) : reader_(reader) {}

  // Fills `positions` (3 x particles, metres) with what lies `after` of the way, 0 to below 1, from
  // frame `index` to the next. At 0 it is the frame, bit for bit. In between particles move on
  // cubics that pass the frames at an even pace (Catmull and Rom): nothing says that they do not
  // pass through each other there. Frames are taken to be equally far apart in time. Fails where
  // one of the two cannot be read; of their neighbours, where there is none, none is needed.
  Result<void> read(int index, double after, Eigen::Matrix3Xf& positions);

 private:
  struct Kept {
    int index = -1;  // none
    Eigen::Matrix3Xf positions;
  };
  // Valid until as many others have been asked for as are kept.
  Result<const Eigen::Matrix3Xf*> frame(int index);
  // A frame that need not be there: otherwise, in `straight_on`, where the way from `before` to
  // `end` would lead.
  const Eigen::Matrix3Xf& frame_or_beyond(int index, const Eigen::Matrix3Xf& before,
                                          const Eigen::Matrix3Xf& end,
                                          Eigen::Matrix3Xf& straight_on);

  RecordingReader& reader_;
  std::array<Kept, 4>
      kept_;  // frame i in place i % 4, so that neighbours never push each other out
};

}  // namespace ribbon

// The sample's frames as they are read back.
#pragma once

#include <gtest/gtest.h>

#include "playback/recording_reader.h"
#include "recording/sample_recording.h"

namespace ribbon {

// Within the bound of the sample's header, with its numbers.
inline void expect_sample_frame(RecordingReader& reader, int frame) {
  Eigen::Matrix3Xf read;
  ASSERT_TRUE(reader.read(frame, read).has_value()) << frame;
  EXPECT_LE((read.cast<double>() - sample_positions(frame)).cwiseAbs().maxCoeff(), 1e-5) << frame;
  EXPECT_EQ(reader.numbers(frame), sample_numbers(frame)) << frame;
}

}  // namespace ribbon

// What pictures are taken of: a model of the scene that is about a metre large.
#pragma once

#include "recording/records/recording.h"

namespace ribbon {

// How large the model of this recording's scene is, for a metre of the scene. Single precision
// holds products of lengths, and what they are compared with, only where these are neither tiny nor
// huge: so cameras, surfaces and lines are the model's, whatever the scene measures. A power of
// two, by which coordinates are not rounded.
float model_scale(const RecordingHeader& header);

// The lengths that are seen are the model's; what is stated of frames stays.
RecordingHeader model_of(RecordingHeader header);

}  // namespace ribbon

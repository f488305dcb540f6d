// The codec of recordings, as rows among others.
#pragma once

#include <vector>

#include "benchmarks/codec/frame_codec.h"

namespace ribbon {

// One row for each way in which recordings choose the references of their frames.
std::vector<CodecRow> own_rows();

}  // namespace ribbon

// What others offer for frames, each library hidden in a file of its own.
#pragma once

#include <vector>

#include "benchmarks/codec/frame_codec.h"

namespace ribbon {

// memcpy; zstd alone; behind byte shuffles of floats, of their bits' differences in time, and of
// quantised integers.
std::vector<CodecRow> byte_rows();

// zfp on each frame's grid (2D) and on grid and time (3D); bound 0 is its reversible mode.
std::vector<CodecRow> zfp_rows();

// Differences in time of quantised integers by meshoptimizer's vertex codec, with and without
// zstd behind it; bound 0 takes the bits of the floats as the integers.
std::vector<CodecRow> meshoptimizer_rows();

// Quantised positions as a point cloud in its order, and as a mesh.
std::vector<CodecRow> draco_rows();

}  // namespace ribbon

// How small, how quick and how true a codec is.
#pragma once

#include <optional>
#include <vector>

#include "benchmarks/codec/frame_codec.h"

namespace ribbon {

struct CodecFigures {
  double bits = 0;             // per particle and frame
  double encode_gb_per_s = 0;  // of the floats, 12 bytes a particle, by the thread's clock
  double decode_gb_per_s = 0;
  double worst_error_m = 0;  // of any coordinate
};

// Seconds that this thread has worked.
double thread_s();

// Measures the setting of `row` that needs fewest bytes while no coordinate is further from the
// truth than task.bound_m; nothing where there is none. blocks: at most block_frames each.
std::optional<CodecFigures> measure(const CodecRow& row, const CodecTask& task,
                                    const std::vector<FrameSpan>& blocks);

}  // namespace ribbon

// What a whole file costs: written, opened, jumped in.
#pragma once

#include <filesystem>

#include "benchmarks/codec/recorded_motion.h"

namespace ribbon {

struct FileFigures {
  int frames = 0;
  double bits = 0;           // of the whole file, per particle and frame
  double open_s = 0;         // median; from the path to a reader that knows all frames
  double seek_median_s = 0;  // to a random frame, decoded
  double seek_p99_s = 0;
};

// Records `frames` frames of the motion, to and fro where it has not that many, with a bound on
// the error of every coordinate (0: exact), into `path`, a file that is new and stays; then opens
// it and jumps in it. By the thread's clock, the file in memory.
Result<FileFigures> measure_file(const RecordedMotion& motion, double bound_m, int frames,
                                 const std::filesystem::path& path);

}  // namespace ribbon

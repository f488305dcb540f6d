// A way to compress frames, as benchmark_recording compares it with others.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/ribbon_grid.h"
#include "recording/records/recording.h"
#include "recording/writer/recording_writer.h"

namespace ribbon {

// Frames one after the other, 3 x particles each, metres.
using FrameSpan = std::span<const Eigen::Matrix3Xf>;

// Compresses groups of frames, each decodable by itself. Only encode() and decode() are timed.
class FrameCodec {
 public:
  FrameCodec() = default;
  FrameCodec(const FrameCodec&) = delete;
  FrameCodec& operator=(const FrameCodec&) = delete;
  virtual ~FrameCodec() = default;

  // The group that the calls below are about, brought into the form that suits the codec best.
  virtual void take(FrameSpan frames) = 0;
  // Bytes that the group takes. Repeatable.
  virtual std::size_t encode() = 0;
  // The group encoded last, from its bytes to floats. Repeatable.
  virtual void decode() = 0;
  // What decode() brought back: frame `index` of the group, 3 x particles.
  [[nodiscard]] virtual Eigen::Matrix3Xf decoded(int index) const = 0;
};

// What a codec is asked for.
struct CodecTask {
  RibbonGrid grid;
  RecordingHeader header;  // of the recording that the frames are from
  double bound_m = 0;      // on the error of every coordinate; 0: the same floats
  double largest_m =
      0;               // of all coordinates, so that quantisation can leave room for their rounding
  double start_m = 0;  // likewise in the first frame
};

// Frames are measured in blocks of so many, which codecs cut into groups.
constexpr int block_frames = 4 * static_cast<int>(ribbon::group_frames);

// One row of the table. Nothing is made where a codec cannot do the task at all.
struct CodecRow {
  using Make = std::function<std::unique_ptr<FrameCodec>(const CodecTask&)>;

  std::string name;
  // Settings that are tried: the one that needs fewest bytes and keeps the bound is measured.
  std::vector<Make> settings = {};
  int group_frames = ribbon::group_frames;  // at most block_frames
};

}  // namespace ribbon

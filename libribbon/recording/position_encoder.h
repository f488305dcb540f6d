// Positions of a frame to bytes, within a hard bound (FORMAT.md, section 8).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>

#include "geometry/ribbon_grid.h"
#include "recording/frame_record.h"
#include "result/result.h"

namespace ribbon {

struct EncodedFrame {
  FrameEncoding encoding{};
  std::uint32_t frames_since_key = 0;
  std::string geometry;
};

class PositionEncoder {
 public:
  // Every decoded coordinate, in single precision, will be within max_error_m of what was encoded.
  PositionEncoder(const RibbonGrid& grid, double max_error_m);
  PositionEncoder(PositionEncoder&&) noexcept;
  PositionEncoder& operator=(PositionEncoder&&) noexcept;
  ~PositionEncoder();

  // positions: 3 x particles in metres. Decodes what it encodes and compares, so the bound does not
  // rest on an argument. Fails, with a place still to be filled in and as if it had not been
  // called, when a coordinate is not finite or single precision is too coarse for the bound.
  Result<EncodedFrame> encode(const Eigen::Matrix3Xd& positions);

  // Makes the next frame independent of earlier ones, for instance because one did not get written.
  void restart();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon

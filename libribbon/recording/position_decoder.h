// Bytes to the positions of a frame (FORMAT.md, section 8).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>

#include "geometry/ribbon_grid.h"
#include "recording/frame_record.h"

namespace ribbon {

class PositionDecoder {
 public:
  explicit PositionDecoder(const RibbonGrid& grid);
  PositionDecoder(PositionDecoder&&) noexcept;
  PositionDecoder& operator=(PositionDecoder&&) noexcept;
  ~PositionDecoder();

  // Takes frames in their order, beginning at a plain or key frame. False when the geometry is not
  // valid; the next frame must then be a plain or key frame.
  bool decode(FrameEncoding encoding, std::string_view geometry);

  // The frame decoded last, resized to 3 x particles.
  void positions(Eigen::Matrix3Xf& positions) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon

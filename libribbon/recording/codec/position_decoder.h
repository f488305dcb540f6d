// Bytes to the positions of a frame (FORMAT.md, section 8).
#pragma once

#include <string_view>

#include "recording/codec/codec_parameters.h"
#include "recording/codec/frame_prediction.h"
#include "recording/codec/quantised_frame.h"
#include "recording/codec/residual_runs.h"

namespace ribbon {

// Keeps working memory between calls and nothing else: equal arguments give equal frames.
class PositionDecoder {
 public:
  explicit PositionDecoder(const CodecParameters& parameters)
      : parameters_(parameters), prediction_(parameters.grid), residuals_(parameters.grid) {}

  // reference: the frame that the encoder had, or none. False, with `frame` undefined, when the
  // geometry is not valid. `frame` may have been used before: its memory is used again.
  bool decode(FrameEncoding encoding, std::string_view geometry, const QuantisedFrame* reference,
              QuantisedFrame& frame);

 private:
  CodecParameters parameters_;
  FramePrediction prediction_;
  ResidualUnpacker unpacker_;
  Residuals residuals_;
};

}  // namespace ribbon

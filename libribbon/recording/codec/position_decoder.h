// Bytes to the positions of a frame (FORMAT.md, section 8).
#pragma once

#include <span>
#include <string_view>

#include "recording/codec/codec_parameters.h"
#include "recording/codec/frame_prediction.h"
#include "recording/codec/quantised_frame.h"
#include "recording/codec/residual_runs.h"
#include "recording/coding/compression.h"

namespace ribbon {

// Keeps working memory between calls and nothing else: equal arguments give equal frames.
class PositionDecoder {
 public:
  explicit PositionDecoder(const CodecParameters& parameters)
      : parameters_(parameters), frame_prediction_(parameters), residuals_(parameters.grid) {}

  // references: the frames that the encoder had, in its order. False, with `frame` undefined, when
  // the geometry is not valid. `frame` may have been used before: its memory is used again.
  bool decode(FrameEncoding encoding, std::string_view geometry,
              std::span<const QuantisedFrame* const> references, QuantisedFrame& frame);

 private:
  bool decode_plain(std::string_view geometry, QuantisedFrame& frame);
  bool decode_quantised(std::string_view geometry,
                        std::span<const QuantisedFrame* const> references, QuantisedFrame& frame);

  CodecParameters parameters_;
  Decompressor decompressor_;
  FramePrediction frame_prediction_;
  ResidualUnpacker unpacker_;
  Residuals residuals_;
};

}  // namespace ribbon

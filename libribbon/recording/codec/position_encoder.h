// Positions of a frame to bytes, within a hard bound (FORMAT.md, section 8).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "recording/codec/codec_parameters.h"
#include "recording/codec/frame_prediction.h"
#include "recording/codec/quantised_frame.h"
#include "recording/codec/residual_runs.h"
#include "result/result.h"

namespace ribbon {

struct EncodedFrame {
  FrameEncoding encoding{};
  std::string geometry;
  QuantisedFrame frame;  // as a decoder will have it
};

// Keeps working memory between calls and nothing else: equal arguments give equal bytes.
class PositionEncoder {
 public:
  // Every decoded coordinate, in single precision, will be within max_error_m of what was encoded;
  // 0: equal to it, rounded to single precision.
  PositionEncoder(const CodecParameters& parameters, double max_error_m)
      : parameters_(parameters),
        max_error_m_(max_error_m),
        prediction_(parameters.grid),
        residuals_(parameters.grid) {}

  // What a decoder will make of positions (3 x particles in metres), however they are encoded.
  // Compares it with them, so the bound does not rest on an argument. Fails, with the
  // error's place still to be filled in, when a coordinate is not finite or single precision is too
  // coarse for the bound.
  [[nodiscard]] Result<QuantisedFrame> rounded(const Eigen::Matrix3Xd& positions) const;

  // Positions, rounded and encoded. reference: a decoded frame, which the decoder will get as well,
  // or none; one that is rounded otherwise is no help. Fails where rounded() does.
  Result<EncodedFrame> encode(const Eigen::Matrix3Xd& positions, const QuantisedFrame* reference);

  // A rounded or a decoded frame: it decodes to the same bits.
  EncodedFrame encode_rounded(QuantisedFrame frame, const QuantisedFrame* reference);

 private:
  [[nodiscard]] std::optional<QuantisedFrame> rounded(const Eigen::Matrix3Xd& positions,
                                                      float step_m) const;

  CodecParameters parameters_;
  double max_error_m_;
  FramePrediction prediction_;
  ResidualPacker packer_;
  Residuals residuals_;
};

}  // namespace ribbon

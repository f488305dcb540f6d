// Bytes to the positions of a frame (FORMAT.md, section 8).
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "recording/codec/codec_parameters.h"
#include "recording/codec/quantised_frame.h"

namespace ribbon {

// Keeps working memory between calls and nothing else: equal arguments give equal frames.
class PositionDecoder {
 public:
  explicit PositionDecoder(const CodecParameters& parameters);
  PositionDecoder(PositionDecoder&&) noexcept;
  PositionDecoder& operator=(PositionDecoder&&) noexcept;
  ~PositionDecoder();

  // references: the frames that the encoder had, in its order. False, with `frame` undefined, when
  // the geometry is not valid. `frame` may have been used before: its memory is used again.
  bool decode(FrameEncoding encoding, std::string_view geometry,
              std::span<const QuantisedFrame* const> references, QuantisedFrame& frame);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon

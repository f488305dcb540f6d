#include "recording/codec/position_decoder.h"

#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

bool take_weights(ByteTaker& taker, RecordedWeights& weights) {
  for (auto& of_column : weights)
    for (std::int16_t& number : of_column) number = taker.take<std::int16_t>();
  return taker.complete();
}

}  // namespace

bool PositionDecoder::decode(FrameEncoding encoding, std::string_view geometry,
                             const QuantisedFrame* reference, QuantisedFrame& frame) {
  frame.grid = parameters_.grid;
  frame.step_m = encoding == FrameEncoding::quantised ? parameters_.step_m : 0;
  if (encoding == FrameEncoding::quantised && !(frame.step_m > 0)) return false;
  prediction_.begin(usable(reference, frame), frame);
  ByteTaker taker(geometry);
  if (!prediction_.is_intra() && !take_weights(taker, prediction_.weights)) return false;
  if (!unpacker_.unpack(taker, residuals_)) return false;
  prediction_.decode(residuals_);
  return true;
}

}  // namespace ribbon

#include "recording/codec/position_decoder.h"

#include "recording/coding/bytes.h"
#include "recording/coding/varint.h"

namespace ribbon {

namespace {

constexpr int largest_shift = 30;

bool take_weights(std::string_view& bytes, RecordedWeights& weights) {
  ByteTaker taker(bytes);
  weights.shift = taker.take<std::uint8_t>();
  bytes = taker.rest();
  if (!taker.complete() || weights.shift > largest_shift) return false;
  bool taken = true;
  weights.for_each([&](std::int32_t& number) {
    const auto next = take_varint(bytes);
    taken = taken && next;
    number = unzigzag(next.value_or(0));
  });
  return taken;
}

}  // namespace

bool PositionDecoder::decode_plain(std::string_view geometry, QuantisedFrame& frame) {
  const std::size_t particles = parameters_.grid.particle_count();
  const auto content = decompressor_.decompress(geometry, particles * 12);
  if (!content || content->size() != particles * 12) return false;
  ByteTaker taker(*content);
  frame.plain_positions.resize(3, parameters_.grid.particle_count());
  for (Eigen::Index c = 0; c < 3; ++c)
    for (float& coordinate : frame.plain_positions.row(c)) coordinate = taker.take<float>();
  return frame.plain_positions.allFinite();
}

bool PositionDecoder::decode_quantised(std::string_view geometry,
                                       std::span<const QuantisedFrame* const> references,
                                       QuantisedFrame& frame) {
  frame_prediction_.begin(references, frame);
  if (!frame_prediction_.is_intra() && !take_weights(geometry, frame_prediction_.weights))
    return false;
  if (!unpacker_.unpack(geometry, residuals_)) return false;
  frame_prediction_.decode(residuals_);
  return frame.is_finite();
}

bool PositionDecoder::decode(FrameEncoding encoding, std::string_view geometry,
                             std::span<const QuantisedFrame* const> references,
                             QuantisedFrame& frame) {
  frame.grid = parameters_.grid;
  frame.step_m = parameters_.step_m;
  frame.plain = encoding == FrameEncoding::plain;
  return frame.plain ? decode_plain(geometry, frame)
                     : decode_quantised(geometry, usable(references), frame);
}

}  // namespace ribbon

#include "recording/codec/position_decoder.h"

#include "recording/coding/bytes.h"
#include "recording/coding/varint.h"

namespace ribbon {

namespace {

constexpr int largest_shift = 30;

bool take_weights(std::string_view& bytes, Prediction prediction, Weights& weights) {
  ByteTaker taker(bytes);
  RecordedWeights recorded{taker.take<std::uint8_t>(), {}};
  bytes = taker.rest();
  if (!taker.complete() || recorded.shift > largest_shift) return false;
  bool taken = true;
  recorded.for_each(prediction, [&](std::int32_t& number) {
    const auto next = take_varint(bytes);
    taken = taken && next;
    number = unzigzag(next.value_or(0));
  });
  weights = recorded.weights();
  return taken;
}

bool take_intra_weights(std::string_view& bytes, IntraWeights& weights) {
  ByteTaker taker(bytes);
  for (MiddleWeights& stage : weights) {
    stage.pairs = static_cast<float>(taker.take<std::int8_t>()) / 64;
    stage.outer = static_cast<float>(taker.take<std::int8_t>()) / 64;
  }
  bytes = taker.rest();
  return taker.complete();
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
  ByteTaker taker(geometry);
  const auto prediction = taker.take<std::uint8_t>();
  geometry = taker.rest();
  if (!taker.complete() || prediction > static_cast<std::uint8_t>(Prediction::b) ||
      (prediction == 0) != references.empty())
    return false;
  frame_prediction_.begin(static_cast<Prediction>(prediction), references);
  const bool taken = prediction == 0 ? take_intra_weights(geometry, frame_prediction_.intra_weights)
                                     : take_weights(geometry, frame_prediction_.prediction(),
                                                    frame_prediction_.weights);
  if (!taken || !unpacker_.unpack(geometry, residuals_)) return false;
  frame_prediction_.decode(residuals_, frame);
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

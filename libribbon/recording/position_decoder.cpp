#include "recording/position_decoder.h"

#include <array>
#include <limits>
#include <memory>
#include <string_view>

#include "recording/bytes.h"
#include "recording/codec_memory.h"
#include "recording/compression.h"
#include "recording/residuals.h"
#include "recording/varint.h"

namespace ribbon {

namespace {

bool take_predictor(std::string_view& bytes, Predictor& predictor) {
  ByteTaker taker(bytes);
  const auto base = taker.take<std::uint8_t>();
  predictor.base = static_cast<PredictionBase>(base);
  predictor.taps = taker.take<std::uint8_t>();
  predictor.shift = taker.take<std::uint8_t>();
  bytes = taker.rest();
  if (!taker.complete() || base > 1 || predictor.taps > (base == 1 ? past_taps : row_taps) ||
      predictor.shift < 1 || predictor.shift > 30)
    return false;
  for (std::size_t tap = 0; tap < static_cast<std::size_t>(predictor.taps); ++tap) {
    const auto coefficient = take_varint(bytes);
    if (!coefficient) return false;
    predictor.coefficients[tap] = unzigzag(*coefficient);
  }
  return true;
}

// Unit, three predictors and the residuals.
std::size_t content_limit(const PaddedGrid& grid) {
  return 8 + 3 * (3 + 5 * past_taps) + packed_residuals_limit(grid);
}

}  // namespace

struct PositionDecoder::State {
  explicit State(const RibbonGrid& ribbon_grid) : memory(ribbon_grid) {}

  CodecMemory memory;
  Decompressor decompressor;
  LatticeFrame frame;
  bool plain = false;  // the last frame is in plain_positions
  Eigen::Matrix3Xf plain_positions;

  bool decode_plain(std::string_view geometry);
  bool decode_key(std::string_view geometry);
  bool decode_delta(std::string_view geometry);
  bool take_parameters(std::string_view content, std::array<Predictor, 3>& predictors);
  [[nodiscard]] auto residual_of(std::size_t component) const;
};

auto PositionDecoder::State::residual_of(std::size_t component) const {
  return [&residuals = frame.residuals[component]](std::size_t at, std::int32_t) {
    return residuals[at];
  };
}

bool PositionDecoder::State::take_parameters(std::string_view content,
                                             std::array<Predictor, 3>& predictors) {
  for (Predictor& predictor : predictors)
    if (!take_predictor(content, predictor)) return false;
  return unpack_residuals(memory.grid, memory.activity, content, frame.residuals);
}

bool PositionDecoder::State::decode_plain(std::string_view geometry) {
  const auto particles = memory.ribbon.particle_count();
  const auto expected = static_cast<std::size_t>(particles) * 12;
  const auto content = decompressor.decompress(geometry, expected);
  if (!content || content->size() != expected) return false;
  ByteTaker taker(*content);
  plain_positions.resize(3, particles);
  for (Eigen::Index c = 0; c < 3; ++c)
    for (Eigen::Index particle = 0; particle < particles; ++particle)
      plain_positions(c, particle) = taker.take<float>();
  plain = plain_positions.allFinite();
  return plain;
}

bool PositionDecoder::State::decode_key(std::string_view geometry) {
  const auto content = decompressor.decompress(geometry, content_limit(memory.grid));
  if (!content) return false;
  ByteTaker taker(*content);
  const auto unit_m = taker.take<double>();
  // Positions must stay within single precision whatever the lattice values are.
  if (!(unit_m > 0) || unit_m * 0x1p31 > static_cast<double>(std::numeric_limits<float>::max()))
    return false;
  memory.activity.forget();
  std::array<Predictor, 3> predictors;
  if (!take_parameters(taker.rest(), predictors)) return false;
  for (const Predictor& predictor : predictors)
    if (predictor.base != PredictionBase::row_above) return false;
  for (std::size_t c = 0; c < 3; ++c) rebuild(memory, c, predictors[c], residual_of(c), frame);
  memory.remember_key(frame);
  memory.unit_m = unit_m;
  return true;
}

bool PositionDecoder::State::decode_delta(std::string_view geometry) {
  if (memory.unit_m == 0) return false;
  const auto content = decompressor.decompress(geometry, content_limit(memory.grid));
  if (!content) return false;
  std::array<Predictor, 3> predictors;
  if (!take_parameters(*content, predictors)) return false;
  for (std::size_t c = 0; c < 3; ++c) rebuild(memory, c, predictors[c], residual_of(c), frame);
  memory.remember_delta(frame);
  return true;
}

PositionDecoder::PositionDecoder(const RibbonGrid& grid) : state_(std::make_unique<State>(grid)) {}
PositionDecoder::PositionDecoder(PositionDecoder&&) noexcept = default;
PositionDecoder& PositionDecoder::operator=(PositionDecoder&&) noexcept = default;
PositionDecoder::~PositionDecoder() = default;

bool PositionDecoder::decode(FrameEncoding encoding, std::string_view geometry) {
  state_->plain = false;
  bool valid = false;
  if (encoding == FrameEncoding::plain) valid = state_->decode_plain(geometry);
  if (encoding == FrameEncoding::key) valid = state_->decode_key(geometry);
  if (encoding == FrameEncoding::delta) valid = state_->decode_delta(geometry);
  if (!valid || state_->plain) state_->memory.unit_m = 0;
  return valid;
}

void PositionDecoder::positions(Eigen::Matrix3Xf& positions) const {
  if (state_->plain) {
    positions = state_->plain_positions;
    return;
  }
  const CodecMemory& memory = state_->memory;
  positions.resize(3, memory.ribbon.particle_count());
  for (std::size_t c = 0; c < 3; ++c)
    for (int i = 0; i < memory.grid.along; ++i)
      for (int j = 0; j < memory.grid.across; ++j)
        positions(static_cast<Eigen::Index>(c), memory.ribbon.particle(i, j)) =
            metres(memory.past[c].position[memory.grid.at(i, j)], memory.unit_m);
}

}  // namespace ribbon

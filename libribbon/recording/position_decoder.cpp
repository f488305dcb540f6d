#include "recording/position_decoder.h"

#include <utility>

#include "recording/bytes.h"
#include "recording/compression.h"

namespace ribbon {

struct PositionDecoder::State {
  CodecParameters parameters;
  Decompressor decompressor;
};

PositionDecoder::PositionDecoder(CodecParameters parameters)
    : state_(std::make_unique<State>(std::move(parameters), Decompressor())) {}
PositionDecoder::PositionDecoder(PositionDecoder&&) noexcept = default;
PositionDecoder& PositionDecoder::operator=(PositionDecoder&&) noexcept = default;
PositionDecoder::~PositionDecoder() = default;

bool PositionDecoder::decode(FrameEncoding encoding, std::string_view geometry,
                             std::span<const LatticeFrame* const> references, LatticeFrame& frame) {
  const RibbonGrid& grid = state_->parameters.grid;
  const auto particles = static_cast<std::size_t>(grid.particle_count());
  const auto content = state_->decompressor.decompress(geometry, particles * 12);
  if (!content || content->size() != particles * 12) return false;
  frame.grid = grid;
  frame.step_m = state_->parameters.step_m;
  frame.plain = encoding == FrameEncoding::plain;
  ByteTaker taker(*content);
  if (frame.plain) {
    frame.plain_positions.resize(3, grid.particle_count());
    for (Eigen::Index c = 0; c < 3; ++c)
      for (float& coordinate : frame.plain_positions.row(c)) coordinate = taker.take<float>();
    return frame.plain_positions.allFinite();
  }
  const bool predicted = !references.empty() && !references[0]->plain;
  for (std::size_t c = 0; c < 3; ++c) {
    frame.numbers[c].resize(particles);
    for (std::size_t p = 0; p < particles; ++p)
      frame.numbers[c][p] = static_cast<std::int32_t>(
          taker.take<std::uint32_t>() +
          (predicted ? static_cast<std::uint32_t>(references[0]->numbers[c][p]) : 0));
  }
  return true;
}

}  // namespace ribbon

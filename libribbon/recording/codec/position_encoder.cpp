#include "recording/codec/position_encoder.h"

#include <utility>

#include "recording/codec/fit_weights.h"
#include "recording/coding/bytes.h"
#include "recording/coding/varint.h"

namespace ribbon {

namespace {

void put_weights(RecordedWeights weights, std::string& bytes) {
  put<std::uint8_t>(bytes, static_cast<std::uint8_t>(weights.shift));
  weights.for_each([&](std::int32_t number) { put_varint(bytes, zigzag(number)); });
}

// Of fewer than 2^51 steps; without a call where the processor has no instruction for it.
double nearest(double steps) {
  constexpr double units_begin = 0x1.8p52;  // numbers so large are 1 apart
  return (steps + units_begin) - units_begin;
}

}  // namespace

void PositionEncoder::set_column(const Eigen::Matrix3Xd& positions, int j,
                                 QuantisedFrame& frame) const {
  const ParticleColumns& columns = frame_prediction_.layout();
  const double over_step = 1 / static_cast<double>(parameters_.step_m);
  const double* position = positions.col(parameters_.grid.particle(0, j)).data();
  for (int i = 0; i < parameters_.grid.along;
       ++i, position += std::ptrdiff_t{3} * parameters_.grid.across)
    for (std::size_t c = 0; c < 3; ++c)
      frame.values[c][columns.cell(i, j)] = static_cast<float>(
          parameters_.step_m > 0 ? nearest(position[c] * over_step) : position[c]);
  continue_over_ends(columns, j, frame.values);
}

std::optional<QuantisedFrame> PositionEncoder::quantised(const Eigen::Matrix3Xd& positions) const {
  QuantisedFrame frame;
  frame.grid = parameters_.grid;
  frame.step_m = parameters_.step_m;
  if (parameters_.step_m > 0 &&
      !(positions.cwiseAbs().maxCoeff() <
        (largest_quantised - 1) * static_cast<double>(parameters_.step_m)))
    return std::nullopt;
  const ParticleColumns& columns = frame_prediction_.layout();
  for (auto& component : frame.values) component.resize(columns.cells());
  for (int j = 0; j < columns.grid().across; ++j) set_column(positions, j, frame);
  return frame;
}

bool PositionEncoder::within_bound(const QuantisedFrame& frame,
                                   const Eigen::Matrix3Xd& positions) const {
  Eigen::Matrix3Xf decoded;
  frame.positions(decoded);
  if (!decoded.allFinite()) return false;
  if (max_error_m_ == 0) return decoded == positions.cast<float>();
  return (decoded.cast<double>() - positions).cwiseAbs().maxCoeff() <= max_error_m_;
}

std::string PositionEncoder::quantised_geometry(QuantisedFrame& frame,
                                                std::span<const QuantisedFrame* const> references) {
  frame_prediction_.begin(references, frame);
  frame_prediction_.set_motion();
  std::string bytes;
  if (!frame_prediction_.is_intra()) {
    frame_prediction_.weights = fit_weights(frame_prediction_, residuals_);
    put_weights(frame_prediction_.weights, bytes);
  }
  frame_prediction_.encode(residuals_);
  packer_.append(residuals_, bytes);
  return bytes;
}

std::string PositionEncoder::plain_geometry(const QuantisedFrame& frame) {
  std::string content;
  for (const float coordinate : frame.plain_positions.transpose().reshaped())
    put<float>(content, coordinate);
  return compressor_.compress(content);
}

Result<QuantisedFrame> PositionEncoder::rounded(const Eigen::Matrix3Xd& positions) const {
  const RibbonGrid& grid = parameters_.grid;
  const bool is_finite = positions.allFinite();
  for (int particle = 0; !is_finite && particle < grid.particle_count(); ++particle)
    if (!positions.col(particle).allFinite())
      return failure("",
                     "particle " + std::to_string(grid.row(particle)) + " along, " +
                         std::to_string(grid.column(particle)) +
                         " across has a position that is not finite",
                     "the simulation has become unstable: choose a smaller time step");
  auto frame = quantised(positions);
  if (frame && within_bound(*frame, positions)) return *std::move(frame);
  QuantisedFrame plain;
  plain.grid = grid;
  plain.plain = true;
  plain.plain_positions = positions.cast<float>();
  if (within_bound(plain, positions)) return plain;
  return failure("",
                 "positions as large as " + std::to_string(positions.cwiseAbs().maxCoeff()) +
                     " m cannot be recorded in single precision within max_position_error",
                 "allow a larger max_position_error or move the scene towards the origin");
}

EncodedFrame PositionEncoder::encode_rounded(QuantisedFrame frame,
                                             std::span<const QuantisedFrame* const> references) {
  const FrameEncoding encoding = frame.plain ? FrameEncoding::plain : FrameEncoding::quantised;
  std::string geometry =
      frame.plain ? plain_geometry(frame) : quantised_geometry(frame, usable(references));
  return {encoding, std::move(geometry), std::move(frame)};
}

Result<EncodedFrame> PositionEncoder::encode(const Eigen::Matrix3Xd& positions,
                                             std::span<const QuantisedFrame* const> references) {
  auto frame = rounded(positions);
  if (!frame) return tl::unexpected(std::move(frame.error()));
  return encode_rounded(*std::move(frame), references);
}

}  // namespace ribbon

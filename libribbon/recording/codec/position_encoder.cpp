#include "recording/codec/position_encoder.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "recording/codec/frame_prediction.h"
#include "recording/codec/residual_blocks.h"
#include "recording/coding/bytes.h"
#include "recording/coding/compression.h"
#include "recording/coding/varint.h"

namespace ribbon {

namespace {

void put_weights(RecordedWeights weights, Prediction prediction, std::string& bytes) {
  put<std::uint8_t>(bytes, static_cast<std::uint8_t>(weights.shift));
  weights.for_each(prediction, [&](std::int32_t number) { put_varint(bytes, zigzag(number)); });
}

void put_intra_weights(const IntraWeights& weights, std::string& bytes) {
  for (const MiddleWeights& stage : weights) {
    put<std::int8_t>(bytes, static_cast<std::int8_t>(64 * stage.pairs));
    put<std::int8_t>(bytes, static_cast<std::int8_t>(64 * stage.outer));
  }
}

// Of fewer than 2^51 steps; without a call where the processor has no instruction for it.
double nearest(double steps) {
  constexpr double units_begin = 0x1.8p52;  // numbers so large are 1 apart
  return (steps + units_begin) - units_begin;
}

}  // namespace

struct PositionEncoder::State {
  State(const CodecParameters& codec, double error)
      : parameters(codec),
        max_error_m(error),
        frame_prediction(codec),
        packer(frame_prediction.planes(), codec.entropy_tables) {}

  CodecParameters parameters;
  double max_error_m;
  Compressor compressor;
  FramePrediction frame_prediction;
  ResidualPacker packer;
  Residuals residuals;

  void set_column(const Eigen::Matrix3Xd& positions, int plane, int b, QuantisedFrame& frame) const;
  [[nodiscard]] std::optional<QuantisedFrame> quantised(const Eigen::Matrix3Xd& positions) const;
  [[nodiscard]] bool within_bound(const QuantisedFrame& frame,
                                  const Eigen::Matrix3Xd& positions) const;
  std::string quantised_geometry(QuantisedFrame& frame, Prediction prediction,
                                 std::span<const QuantisedFrame* const> references, Fit fit);
  std::string plain_geometry(const QuantisedFrame& frame);
};

void PositionEncoder::State::set_column(const Eigen::Matrix3Xd& positions, int plane, int b,
                                        QuantisedFrame& frame) const {
  const PolyphasePlanes& planes = frame_prediction.planes();
  const double over_step = 1 / static_cast<double>(parameters.step_m);
  const std::size_t cell = planes.cell(plane, 0, b);
  const Triple<float*> values = {&frame.values[0][cell], &frame.values[1][cell],
                                 &frame.values[2][cell]};
  const double* position =
      positions.data() + std::ptrdiff_t{3} * parameters.grid.particle(plane / 2, 2 * b + plane % 2);
  for (int a = 0; a < planes.rows(plane);
       ++a, position += std::ptrdiff_t{6} * parameters.grid.across)
    for (std::size_t c = 0; c < 3; ++c)
      values[c][a] = static_cast<float>(parameters.step_m > 0 ? nearest(position[c] * over_step)
                                                              : position[c]);
}

std::optional<QuantisedFrame> PositionEncoder::State::quantised(
    const Eigen::Matrix3Xd& positions) const {
  const PolyphasePlanes& planes = frame_prediction.planes();
  QuantisedFrame frame;
  frame.grid = parameters.grid;
  frame.step_m = parameters.step_m;
  if (parameters.step_m > 0 && !(positions.cwiseAbs().maxCoeff() <
                                 (largest_quantised - 1) * static_cast<double>(parameters.step_m)))
    return std::nullopt;
  for (auto& component : frame.values) component.resize(planes.cells());
  for (int plane = 0; plane < PolyphasePlanes::count; ++plane)
    for (int b = 0; b < planes.columns(plane); ++b) set_column(positions, plane, b, frame);
  frame.continue_values();
  return frame;
}

bool PositionEncoder::State::within_bound(const QuantisedFrame& frame,
                                          const Eigen::Matrix3Xd& positions) const {
  Eigen::Matrix3Xf decoded;
  frame.positions(decoded);
  if (!decoded.allFinite()) return false;
  if (max_error_m == 0) return decoded == positions.cast<float>();
  return (decoded.cast<double>() - positions).cwiseAbs().maxCoeff() <= max_error_m;
}

std::string PositionEncoder::State::quantised_geometry(
    QuantisedFrame& frame, Prediction prediction, std::span<const QuantisedFrame* const> references,
    Fit fit) {
  frame_prediction.begin(prediction, references);
  frame_prediction.set(frame);
  std::string bytes;
  put<std::uint8_t>(bytes, static_cast<std::uint8_t>(frame_prediction.prediction()));
  if (frame_prediction.prediction() == Prediction::intra) {
    frame_prediction.intra_weights =
        fit_intra_weights(frame_prediction.planes(), frame_prediction.motion());
    put_intra_weights(frame_prediction.intra_weights, bytes);
  } else {
    const RecordedWeights recorded = fit_weights(frame_prediction.predicted(), fit);
    frame_prediction.weights = recorded.weights();
    put_weights(recorded, frame_prediction.prediction(), bytes);
  }
  frame_prediction.encode(residuals);
  packer.append(residuals, bytes);
  return bytes;
}

std::string PositionEncoder::State::plain_geometry(const QuantisedFrame& frame) {
  std::string content;
  for (const float coordinate : frame.plain_positions.transpose().reshaped())
    put<float>(content, coordinate);
  return compressor.compress(content);
}

PositionEncoder::PositionEncoder(const CodecParameters& parameters, double max_error_m)
    : state_(std::make_unique<State>(parameters, max_error_m)) {}
PositionEncoder::PositionEncoder(PositionEncoder&&) noexcept = default;
PositionEncoder& PositionEncoder::operator=(PositionEncoder&&) noexcept = default;
PositionEncoder::~PositionEncoder() = default;

const SymbolRuns& PositionEncoder::symbol_runs() const {
  return state_->packer.runs();
}

Result<QuantisedFrame> PositionEncoder::rounded(const Eigen::Matrix3Xd& positions) const {
  const RibbonGrid& grid = state_->parameters.grid;
  const bool is_finite = positions.allFinite();
  for (int particle = 0; !is_finite && particle < grid.particle_count(); ++particle)
    if (!positions.col(particle).allFinite())
      return failure("",
                     "particle " + std::to_string(grid.row(particle)) + " along, " +
                         std::to_string(grid.column(particle)) +
                         " across has a position that is not finite",
                     "the simulation has become unstable: choose a smaller time step");
  auto frame = state_->quantised(positions);
  if (frame && state_->within_bound(*frame, positions)) return *std::move(frame);
  QuantisedFrame plain;
  plain.grid = grid;
  plain.plain = true;
  plain.plain_positions = positions.cast<float>();
  if (state_->within_bound(plain, positions)) return plain;
  return failure("",
                 "positions as large as " + std::to_string(positions.cwiseAbs().maxCoeff()) +
                     " m cannot be recorded in single precision within max_position_error",
                 "allow a larger max_position_error or move the scene towards the origin");
}

EncodedFrame PositionEncoder::encode_rounded(QuantisedFrame frame,
                                             std::span<const QuantisedFrame* const> references,
                                             Prediction prediction, Fit fit) {
  const FrameEncoding encoding = frame.plain ? FrameEncoding::plain : FrameEncoding::quantised;
  std::string geometry =
      frame.plain ? state_->plain_geometry(frame)
                  : state_->quantised_geometry(frame, prediction, usable(references), fit);
  return {encoding, std::move(geometry), std::move(frame)};
}

Result<EncodedFrame> PositionEncoder::encode(const Eigen::Matrix3Xd& positions,
                                             std::span<const QuantisedFrame* const> references,
                                             Prediction prediction) {
  auto frame = rounded(positions);
  if (!frame) return tl::unexpected(std::move(frame.error()));
  return encode_rounded(*std::move(frame), references, prediction, Fit::quick);
}

}  // namespace ribbon

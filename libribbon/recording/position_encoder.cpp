#include "recording/position_encoder.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "recording/bytes.h"
#include "recording/compression.h"

namespace ribbon {

struct PositionEncoder::State {
  CodecParameters parameters;
  double max_error_m;
  Compressor compressor;

  [[nodiscard]] std::optional<LatticeFrame> on_lattice(const Eigen::Matrix3Xd& positions) const;
  [[nodiscard]] bool within_bound(const LatticeFrame& frame,
                                  const Eigen::Matrix3Xd& positions) const;
  std::string lattice_geometry(const LatticeFrame& frame,
                               std::span<const LatticeFrame* const> references);
  std::optional<EncodedFrame> try_plain(const Eigen::Matrix3Xd& positions);
};

std::optional<LatticeFrame> PositionEncoder::State::on_lattice(
    const Eigen::Matrix3Xd& positions) const {
  constexpr double largest_number = 1 << 30;
  LatticeFrame frame{parameters.grid, parameters.step_m, {}, false, {}};
  for (std::size_t c = 0; c < 3; ++c)
    for (const double coordinate : positions.row(static_cast<Eigen::Index>(c))) {
      if (parameters.step_m == 0) {
        frame.numbers[c].push_back(ordered_number(static_cast<float>(coordinate)));
        continue;
      }
      const double number = std::floor(coordinate / parameters.step_m + 0.5);
      if (!(std::abs(number) < largest_number)) return std::nullopt;
      frame.numbers[c].push_back(static_cast<std::int32_t>(number));
    }
  return frame;
}

bool PositionEncoder::State::within_bound(const LatticeFrame& frame,
                                          const Eigen::Matrix3Xd& positions) const {
  Eigen::Matrix3Xf decoded;
  frame.positions(decoded);
  if (!decoded.allFinite()) return false;
  if (max_error_m == 0) return decoded == positions.cast<float>();
  return (decoded.cast<double>() - positions).cwiseAbs().maxCoeff() <= max_error_m;
}

std::string PositionEncoder::State::lattice_geometry(
    const LatticeFrame& frame, std::span<const LatticeFrame* const> references) {
  std::string content;
  const bool predicted = !references.empty() && !references[0]->plain;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t p = 0; p < frame.numbers[c].size(); ++p)
      put<std::uint32_t>(
          content, static_cast<std::uint32_t>(frame.numbers[c][p]) -
                       (predicted ? static_cast<std::uint32_t>(references[0]->numbers[c][p]) : 0));
  return compressor.compress(std::array{std::string_view(content)});
}

std::optional<EncodedFrame> PositionEncoder::State::try_plain(const Eigen::Matrix3Xd& positions) {
  EncodedFrame encoded{
      FrameEncoding::plain, {}, {parameters.grid, parameters.step_m, {}, true, {}}};
  std::string content;
  for (const double coordinate : positions.transpose().reshaped())
    put<float>(content, static_cast<float>(coordinate));
  encoded.frame.plain_positions = positions.cast<float>();
  if (!within_bound(encoded.frame, positions)) return std::nullopt;
  encoded.geometry = compressor.compress(std::array{std::string_view(content)});
  return encoded;
}

PositionEncoder::PositionEncoder(CodecParameters parameters, double max_error_m)
    : state_(std::make_unique<State>(std::move(parameters), max_error_m, Compressor())) {}
PositionEncoder::PositionEncoder(PositionEncoder&&) noexcept = default;
PositionEncoder& PositionEncoder::operator=(PositionEncoder&&) noexcept = default;
PositionEncoder::~PositionEncoder() = default;

Result<EncodedFrame> PositionEncoder::encode(const Eigen::Matrix3Xd& positions,
                                             std::span<const LatticeFrame* const> references) {
  for (Eigen::Index particle = 0; particle < positions.cols(); ++particle)
    if (!positions.col(particle).allFinite()) {
      const int number = static_cast<int>(particle);
      const RibbonGrid& grid = state_->parameters.grid;
      return failure("",
                     "particle " + std::to_string(grid.row(number)) + " along, " +
                         std::to_string(grid.column(number)) +
                         " across has a position that is not finite",
                     "the simulation has become unstable: choose a smaller time step");
    }
  auto frame = state_->on_lattice(positions);
  if (frame && state_->within_bound(*frame, positions)) {
    std::string geometry = state_->lattice_geometry(*frame, references);
    return EncodedFrame{FrameEncoding::lattice, std::move(geometry), std::move(*frame)};
  }
  if (auto plain = state_->try_plain(positions)) return std::move(*plain);
  return failure("",
                 "positions as large as " + std::to_string(positions.cwiseAbs().maxCoeff()) +
                     " m cannot be recorded in single precision within max_position_error",
                 "allow a larger max_position_error or move the scene towards the origin");
}

}  // namespace ribbon

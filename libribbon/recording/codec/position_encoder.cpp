#include "recording/codec/position_encoder.h"

#include <limits>
#include <utility>

#include "recording/codec/fit_weights.h"
#include "recording/coding/bytes.h"

namespace ribbon {

namespace {

void put_weights(const RecordedWeights& weights, std::string& bytes) {
  for (const auto& of_column : weights)
    for (const std::int16_t number : of_column) put<std::int16_t>(bytes, number);
}

// Whole numbers of steps, those in the middle to the even one, as double precision rounds where
// numbers are 1 apart; without a call where the processor has no instruction for it.
Eigen::Matrix3Xf steps(const Eigen::Matrix3Xd& positions, double step_m) {
  constexpr double whole_from = 0x1.8p52;
  return ((positions.array() * (1 / step_m) + whole_from) - whole_from).matrix().cast<float>();
}

}  // namespace

// Nothing where they are too far out to be rounded so within the bound.
std::optional<QuantisedFrame> PositionEncoder::rounded(const Eigen::Matrix3Xd& positions,
                                                       float step_m) const {
  constexpr double largest = std::numeric_limits<float>::max();
  const double reach_m =
      step_m > 0 ? (largest_quantised - 1) * static_cast<double>(step_m) : largest;
  if (positions.cwiseAbs().maxCoeff() > reach_m) return std::nullopt;
  const Eigen::Matrix3Xf values = step_m > 0 ? steps(positions, step_m) : positions.cast<float>();
  const Eigen::Matrix3Xf decoded = values * (step_m > 0 ? step_m : 1);
  const double error_m = (decoded.cast<double>() - positions).cwiseAbs().maxCoeff();
  if (error_m > (max_error_m_ > 0 ? max_error_m_ : largest)) return std::nullopt;
  QuantisedFrame frame;
  frame.grid = parameters_.grid;
  frame.step_m = step_m;
  const ParticleColumns& columns = prediction_.layout();
  for (std::size_t c = 0; c < 3; ++c) {
    frame.values[c].resize(columns.cells());
    for (int i = 0; i < frame.grid.along; ++i)
      for (int j = 0; j < frame.grid.across; ++j)
        frame.values[c][columns.cell(i, j)] =
            values(static_cast<Eigen::Index>(c), frame.grid.particle(i, j));
  }
  for (int j = 0; j < frame.grid.across; ++j) continue_over_ends(columns, j, frame.values);
  return frame;
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
  auto frame = rounded(positions, parameters_.step_m);
  if (!frame && parameters_.step_m > 0) frame = rounded(positions, 0);
  if (frame) return *std::move(frame);
  return failure(
      "",
      "positions as large as " + std::to_string(positions.cwiseAbs().maxCoeff()) +
          " m cannot be recorded in single precision within the position error asked for",
      "allow a larger position error or move the scene towards the origin");
}

EncodedFrame PositionEncoder::encode_rounded(QuantisedFrame frame,
                                             const QuantisedFrame* reference) {
  prediction_.begin(usable(reference, frame), frame);
  std::string geometry;
  if (!prediction_.is_intra()) {
    prediction_.weights = fit_weights(prediction_, residuals_);
    put_weights(prediction_.weights, geometry);
  }
  prediction_.encode(residuals_);
  packer_.append(residuals_, geometry);
  return {frame.step_m > 0 ? FrameEncoding::quantised : FrameEncoding::exact, std::move(geometry),
          std::move(frame)};
}

Result<EncodedFrame> PositionEncoder::encode(const Eigen::Matrix3Xd& positions,
                                             const QuantisedFrame* reference) {
  auto frame = rounded(positions);
  if (!frame) return tl::unexpected(std::move(frame.error()));
  return encode_rounded(*std::move(frame), reference);
}

}  // namespace ribbon

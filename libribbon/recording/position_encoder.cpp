#include "recording/position_encoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "recording/bytes.h"
#include "recording/codec_memory.h"
#include "recording/compression.h"
#include "recording/fit_prediction.h"
#include "recording/residuals.h"
#include "recording/varint.h"

namespace ribbon {

namespace {

// Longer groups are smaller and slower to seek in: 16 costs 6 % more bytes, 64 saves 3 %.
constexpr std::uint32_t frames_per_group = 32;

// Lattice values stay below this, so that differences of two never wrap around in the encoder.
constexpr double largest_lattice_value = 1 << 29;

constexpr std::size_t sample_limit = 2000;
constexpr std::array past_tap_choices{1, 6, past_taps};
constexpr std::array row_tap_choices{1, row_taps};

std::string packed_predictors(const std::array<Predictor, 3>& predictors) {
  std::string bytes;
  for (const Predictor& predictor : predictors) {
    put<std::uint8_t>(bytes, static_cast<std::uint8_t>(predictor.base));
    put<std::uint8_t>(bytes, static_cast<std::uint8_t>(predictor.taps));
    put<std::uint8_t>(bytes, static_cast<std::uint8_t>(predictor.shift));
    for (std::size_t tap = 0; tap < static_cast<std::size_t>(predictor.taps); ++tap)
      put_varint(bytes, zigzag(predictor.coefficients[tap]));
  }
  return bytes;
}

}  // namespace

struct PositionEncoder::State {
  State(const RibbonGrid& ribbon_grid, double error) : memory(ribbon_grid), max_error_m(error) {}

  CodecMemory memory;
  double max_error_m;
  std::uint32_t frames_since_key = 0;
  Compressor compressor;

  std::array<std::vector<double>, 3> target;  // in lattice units, padded
  LatticeFrame frame;

  void set_target(const Eigen::Matrix3Xd& positions, double unit_m);
  [[nodiscard]] bool within_bound(const Eigen::Matrix3Xd& positions, double unit_m) const;
  [[nodiscard]] std::vector<std::size_t> sampled_particles() const;
  [[nodiscard]] Fit fit_from_past(std::size_t component) const;
  [[nodiscard]] Fit fit_from_rows(std::size_t component) const;
  auto residual_of(std::size_t component);
  std::string compressed(const std::string& prefix, const Activity& activity);

  std::optional<EncodedFrame> try_delta(const Eigen::Matrix3Xd& positions);
  std::optional<EncodedFrame> try_key(const Eigen::Matrix3Xd& positions);
  std::optional<EncodedFrame> try_plain(const Eigen::Matrix3Xd& positions);
};

void PositionEncoder::State::set_target(const Eigen::Matrix3Xd& positions, double unit_m) {
  const PaddedGrid& grid = memory.grid;
  for (std::size_t c = 0; c < 3; ++c) {
    target[c].assign(grid.size(), 0);
    for (int i = 0; i < grid.along; ++i)
      for (int j = 0; j < grid.across; ++j)
        target[c][grid.at(i, j)] =
            positions(static_cast<Eigen::Index>(c), memory.ribbon.particle(i, j)) / unit_m;
  }
}

bool PositionEncoder::State::within_bound(const Eigen::Matrix3Xd& positions, double unit_m) const {
  const PaddedGrid& grid = memory.grid;
  double worst = 0;
  for (std::size_t c = 0; c < 3; ++c)
    for (int i = 0; i < grid.along; ++i)
      for (int j = 0; j < grid.across; ++j) {
        const double decoded = metres(frame.position[c][grid.at(i, j)], unit_m);
        const double truth = positions(static_cast<Eigen::Index>(c), memory.ribbon.particle(i, j));
        worst = std::max(worst, std::abs(decoded - truth));
      }
  return worst <= max_error_m;
}

// Evenly spread, and over all columns.
std::vector<std::size_t> PositionEncoder::State::sampled_particles() const {
  const auto count = static_cast<std::size_t>(memory.ribbon.particle_count());
  std::size_t spacing = (count + sample_limit - 1) / sample_limit;
  while (std::gcd(spacing, static_cast<std::size_t>(memory.ribbon.across)) > 1) ++spacing;
  std::vector<std::size_t> places;
  for (std::size_t particle = 0; particle < count; particle += spacing)
    places.push_back(memory.grid.at(memory.ribbon.row(static_cast<int>(particle)),
                                    memory.ribbon.column(static_cast<int>(particle))));
  return places;
}

Fit PositionEncoder::State::fit_from_past(std::size_t component) const {
  const PaddedGrid& grid = memory.grid;
  const Past& past = memory.past[component];
  Field change(grid.size());
  for (int i = 0; i < grid.along; ++i) {
    open_row(grid, i, change);
    for (std::size_t at = grid.at(i, 0); at < grid.at(i, grid.across); ++at)
      change[at] =
          static_cast<std::int32_t>(std::floor(target[component][at] + 0.5)) - past.position[at];
    close_row(grid, i, change);
  }
  std::vector<Sample> samples;
  for (const std::size_t at : sampled_particles()) {
    samples.push_back({taps_from_past(grid, past, change, at), change[at]});
    // The border on the left held the value above when the first particle of a row was predicted.
    if ((at - 1) % static_cast<std::size_t>(grid.stride) == 0)
      samples.back().taps[2] = change[at - static_cast<std::size_t>(grid.stride)];
  }
  Fit fit = fit_predictor(samples, past_tap_choices, memory.ribbon.particle_count());
  fit.predictor.base = PredictionBase::previous_frame;
  return fit;
}

Fit PositionEncoder::State::fit_from_rows(std::size_t component) const {
  const PaddedGrid& grid = memory.grid;
  Field position(grid.size());
  Field change(grid.size());
  for (int i = 0; i < grid.along; ++i) {
    for (std::size_t at = grid.at(i, 0); at < grid.at(i, grid.across); ++at) {
      position[at] = static_cast<std::int32_t>(std::floor(target[component][at] + 0.5));
      if (i > 0) change[at] = position[at] - position[at - static_cast<std::size_t>(grid.stride)];
    }
    close_row(grid, i, position);
    close_row(grid, i, change);
  }
  std::vector<Sample> samples;
  for (const std::size_t at : sampled_particles()) {
    if (at < grid.at(1, 0)) continue;
    samples.push_back({taps_from_rows(grid, position, change, at), change[at]});
    if ((at - 1) % static_cast<std::size_t>(grid.stride) == 0)
      samples.back().taps[0] = change[at - static_cast<std::size_t>(grid.stride)];
  }
  return fit_predictor(samples, row_tap_choices, memory.ribbon.particle_count());
}

// Makes the residual that brings a prediction nearest to the target, and notes it.
auto PositionEncoder::State::residual_of(std::size_t component) {
  frame.residuals[component].resize(memory.grid.size());
  return [&wanted = target[component], &noted = frame.residuals[component]](
             std::size_t at, std::int32_t prediction) {
    constexpr double steps_per_unit = 1.0 / units_per_step;
    const double steps = (wanted[at] - static_cast<double>(prediction)) * steps_per_unit;
    return noted[at] = static_cast<std::int32_t>(std::floor(steps + 0.5));
  };
}

std::string PositionEncoder::State::compressed(const std::string& prefix,
                                               const Activity& activity) {
  std::vector<std::string> parts = pack_residuals(memory.grid, activity, frame.residuals);
  parts[0].insert(0, prefix);
  std::vector<std::string_view> views;
  for (const std::string& part : parts)
    if (!part.empty()) views.emplace_back(part);
  return compressor.compress(views);
}

std::optional<EncodedFrame> PositionEncoder::State::try_delta(const Eigen::Matrix3Xd& positions) {
  if (memory.unit_m == 0 || frames_since_key + 1 >= frames_per_group ||
      positions.cwiseAbs().maxCoeff() > largest_lattice_value * memory.unit_m)
    return std::nullopt;
  set_target(positions, memory.unit_m);
  std::array<Predictor, 3> predictors;
  for (std::size_t c = 0; c < 3; ++c) {
    const Fit from_past = fit_from_past(c);
    const Fit from_rows = fit_from_rows(c);
    predictors[c] = from_past.bits < from_rows.bits ? from_past.predictor : from_rows.predictor;
    rebuild(memory, c, predictors[c], residual_of(c), frame);
  }
  if (!within_bound(positions, memory.unit_m)) return std::nullopt;
  EncodedFrame result{FrameEncoding::delta, ++frames_since_key,
                      compressed(packed_predictors(predictors), memory.activity)};
  memory.remember_delta(frame);
  return result;
}

std::optional<EncodedFrame> PositionEncoder::State::try_key(const Eigen::Matrix3Xd& positions) {
  // Single precision rounds by up to 2^-24 of the coordinate; an eighth more lets the ribbon move
  // on until the next key frame.
  const double largest = positions.cwiseAbs().maxCoeff();
  const double step_m = 2 * (max_error_m - 1.125 * std::ldexp(largest, -24));
  const double unit_m = step_m / units_per_step;
  if (step_m < 0.5 * max_error_m || largest > largest_lattice_value * unit_m) return std::nullopt;
  set_target(positions, unit_m);
  std::array<Predictor, 3> predictors;
  for (std::size_t c = 0; c < 3; ++c) {
    predictors[c] = fit_from_rows(c).predictor;
    rebuild(memory, c, predictors[c], residual_of(c), frame);
  }
  if (!within_bound(positions, unit_m)) return std::nullopt;
  std::string prefix;
  put<double>(prefix, unit_m);
  memory.activity.forget();
  EncodedFrame result{FrameEncoding::key, 0,
                      compressed(prefix + packed_predictors(predictors), memory.activity)};
  memory.unit_m = unit_m;
  memory.remember_key(frame);
  frames_since_key = 0;
  return result;
}

std::optional<EncodedFrame> PositionEncoder::State::try_plain(const Eigen::Matrix3Xd& positions) {
  std::string content;
  for (const double coordinate : positions.transpose().reshaped()) {
    if (std::abs(coordinate) > static_cast<double>(std::numeric_limits<float>::max()) ||
        std::abs(static_cast<double>(static_cast<float>(coordinate)) - coordinate) > max_error_m)
      return std::nullopt;
    put<float>(content, static_cast<float>(coordinate));
  }
  memory.unit_m = 0;
  return EncodedFrame{FrameEncoding::plain, 0,
                      compressor.compress(std::array{std::string_view(content)})};
}

PositionEncoder::PositionEncoder(const RibbonGrid& grid, double max_error_m)
    : state_(std::make_unique<State>(grid, max_error_m)) {}
PositionEncoder::PositionEncoder(PositionEncoder&&) noexcept = default;
PositionEncoder& PositionEncoder::operator=(PositionEncoder&&) noexcept = default;
PositionEncoder::~PositionEncoder() = default;

void PositionEncoder::restart() {
  state_->memory.unit_m = 0;
}

Result<EncodedFrame> PositionEncoder::encode(const Eigen::Matrix3Xd& positions) {
  for (Eigen::Index particle = 0; particle < positions.cols(); ++particle)
    if (!positions.col(particle).allFinite()) {
      const int number = static_cast<int>(particle);
      const RibbonGrid& grid = state_->memory.ribbon;
      return failure("",
                     "particle " + std::to_string(grid.row(number)) + " along, " +
                         std::to_string(grid.column(number)) +
                         " across has a position that is not finite",
                     "the simulation has become unstable: choose a smaller time step");
    }
  auto frame = state_->try_delta(positions);
  if (!frame) frame = state_->try_key(positions);
  if (!frame) frame = state_->try_plain(positions);
  if (frame) return std::move(*frame);
  return failure("",
                 "positions as large as " + std::to_string(positions.cwiseAbs().maxCoeff()) +
                     " m cannot be recorded in single precision within max_position_error",
                 "allow a larger max_position_error or move the scene towards the origin");
}

}  // namespace ribbon

#include "recording/position_codec.h"

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "recording/bytes.h"
#include "recording/compression.h"
#include "recording/fit_prediction.h"
#include "recording/prediction.h"
#include "recording/residuals.h"

namespace ribbon {

namespace {

// Longer groups are smaller and slower to seek in: 16 costs 5 % more bytes, 64 saves 2 %.
constexpr std::uint32_t frames_per_group = 32;

// Lattice values stay below this, so that differences of two never wrap around in the encoder.
constexpr double largest_lattice_value = 1 << 29;

constexpr std::size_t sample_limit = 2000;
constexpr std::array past_tap_choices{1, 6, past_taps};
constexpr std::array row_tap_choices{1, row_taps};

struct LatticeFrame {
  std::array<Field, 3> position;
  std::array<Field, 3> change;
  Residuals residuals;
};

// What both sides remember from frame to frame.
struct Memory {
  explicit Memory(const RibbonGrid& ribbon_grid)
      : ribbon(ribbon_grid), grid(ribbon_grid), activity(grid) {}

  RibbonGrid ribbon;
  PaddedGrid grid;
  double unit_m = 0;  // metres per lattice unit; 0: nothing that a delta frame could build upon
  std::array<Past, 3> past;
  Activity activity;

  void remember_key(LatticeFrame& frame) {
    for (std::size_t c = 0; c < 3; ++c) {
      past[c].position.swap(frame.position[c]);
      grid.replicate_border(past[c].position);
      past[c].motion.assign(grid.size(), 0);
      past[c].older_motion.assign(grid.size(), 0);
    }
    activity.forget();
  }

  void remember_delta(LatticeFrame& frame) {
    for (std::size_t c = 0; c < 3; ++c) {
      grid.replicate_border(frame.position[c]);
      past[c].older_motion.swap(past[c].motion);
      for (std::size_t at = 0; at < grid.size(); ++at)
        past[c].motion[at] = wrapping_subtract(frame.position[c][at], past[c].position[at]);
      past[c].position.swap(frame.position[c]);
    }
    activity.remember(frame.residuals);
  }
};

// The one place where lattice values become metres: one product and one rounding to single
// precision.
float metres(std::int32_t lattice_value, double unit_m) {
  return static_cast<float>(static_cast<double>(lattice_value) * unit_m);
}

// One component of a frame, from its predictor and its residuals.
template <class Residual>
void rebuild(const Memory& memory, std::size_t component, const Predictor& predictor,
             Residual residual, LatticeFrame& frame) {
  Field& position = frame.position[component];
  Field& change = frame.change[component];
  if (predictor.base == PredictionBase::previous_frame)
    rebuild_from_past(memory.grid, memory.past[component], predictor, residual, position, change);
  else
    rebuild_from_rows(memory.grid, predictor, residual, position, change);
}

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

}  // namespace

struct PositionEncoder::State {
  State(const RibbonGrid& ribbon_grid, double error) : memory(ribbon_grid), max_error_m(error) {}

  Memory memory;
  double max_error_m;
  std::uint32_t frames_since_key = 0;
  Compressor compressor;

  std::array<std::vector<double>, 3> target;  // in lattice units, padded
  LatticeFrame frame;

  void set_target(const Eigen::Matrix3Xd& positions, double unit_m);
  bool within_bound(const Eigen::Matrix3Xd& positions, double unit_m) const;
  std::vector<std::size_t> sampled_particles() const;
  Fit fit_from_past(std::size_t component) const;
  Fit fit_from_rows(std::size_t component) const;
  auto residual_of(std::size_t component);
  std::string compressed(std::string prefix, const Activity& activity);

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

std::string PositionEncoder::State::compressed(std::string prefix, const Activity& activity) {
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

struct PositionDecoder::State {
  explicit State(const RibbonGrid& ribbon_grid) : memory(ribbon_grid) {}

  Memory memory;
  Decompressor decompressor;
  LatticeFrame frame;
  bool plain = false;  // the last frame is in plain_positions
  Eigen::Matrix3Xf plain_positions;

  bool decode_plain(std::string_view geometry);
  bool decode_key(std::string_view geometry);
  bool decode_delta(std::string_view geometry);
  bool take_parameters(std::string_view content, std::array<Predictor, 3>& predictors);
  auto residual_of(std::size_t component) const;
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
  plain = true;
  return true;
}

// Parameters of three predictors at most, the unit and the residuals.
std::size_t content_limit(const PaddedGrid& grid) {
  return 8 + 3 * (3 + 5 * past_taps) + packed_residuals_limit(grid);
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
  const Memory& memory = state_->memory;
  positions.resize(3, memory.ribbon.particle_count());
  for (std::size_t c = 0; c < 3; ++c)
    for (int i = 0; i < memory.grid.along; ++i)
      for (int j = 0; j < memory.grid.across; ++j)
        positions(static_cast<Eigen::Index>(c), memory.ribbon.particle(i, j)) =
            metres(memory.past[c].position[memory.grid.at(i, j)], memory.unit_m);
}

}  // namespace ribbon

// Encoder and decoder of positions together.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "files/flipped.h"
#include "recording/codec/position_decoder.h"
#include "recording/codec/position_encoder.h"
#include "recording/sample_recording.h"
#include "recording/writer/recording_writer.h"
#include "result/refusal.h"

namespace ribbon::position_codec_test {

constexpr double bound_m = 1e-5;

CodecParameters parameters(const RibbonGrid& grid, double max_error_m, double reach_m) {
  return {grid, quantisation_step_m(max_error_m, reach_m)};
}

// Encodes and decodes frames as a writer does.
class RoundTrip {
 public:
  RoundTrip(const CodecParameters& codec, double max_error_m)
      : encoder_(codec, max_error_m), decoder_(codec), max_error_m_(max_error_m) {}

  // Every coordinate must keep the bound. Returns the geometry.
  EncodedFrame take(const Eigen::Matrix3Xd& truth) {
    const auto before = reference_of(static_cast<std::uint32_t>(decoded_.size()));
    const QuantisedFrame* reference = before ? &decoded_[*before] : nullptr;
    auto encoded = encoder_.encode(truth, reference);
    if (!encoded) {
      ADD_FAILURE() << encoded.error().sentence();
      return {};
    }
    QuantisedFrame frame;
    EXPECT_TRUE(decoder_.decode(encoded->encoding, encoded->geometry, reference, frame));
    Eigen::Matrix3Xf positions;
    frame.positions(positions);
    EXPECT_LE((positions.cast<double>() - truth).cwiseAbs().maxCoeff(), max_error_m_)
        << "frame " << decoded_.size();
    Eigen::Matrix3Xf expected;
    encoded->frame.positions(expected);
    EXPECT_EQ(positions, expected);
    decoded_.push_back(std::move(frame));
    return std::move(*encoded);
  }

 private:
  PositionEncoder encoder_;
  PositionDecoder decoder_;
  double max_error_m_;
  std::vector<QuantisedFrame> decoded_;
};

std::vector<FrameEncoding> round_trip(const CodecParameters& codec, double max_error_m,
                                      const std::vector<Eigen::Matrix3Xd>& frames) {
  RoundTrip trip(codec, max_error_m);
  std::vector<FrameEncoding> encodings;
  encodings.reserve(frames.size());
  for (const Eigen::Matrix3Xd& frame : frames) encodings.push_back(trip.take(frame).encoding);
  return encodings;
}

std::vector<Eigen::Matrix3Xd> sample_frames(int count) {
  std::vector<Eigen::Matrix3Xd> frames;
  frames.reserve(count);
  for (int frame = 0; frame < count; ++frame) frames.push_back(sample_positions(frame));
  return frames;
}

// Uniform noise between -size and size.
Eigen::Matrix3Xd noise(int particles, double size, unsigned seed) {
  std::mt19937 random(seed);
  Eigen::Matrix3Xd positions(3, particles);
  for (double& coordinate : positions.reshaped())
    coordinate = size * (static_cast<double>(random()) / 2147483648.0 - 1);
  return positions;
}

const RibbonGrid sample_grid{40, 6};

TEST(PositionCodec, a_twisting_ribbon_stays_within_the_bound) {
  for (const FrameEncoding encoding :
       round_trip(parameters(sample_grid, bound_m, 1), bound_m, sample_frames(70)))
    EXPECT_EQ(encoding, FrameEncoding::quantised);
}

TEST(PositionCodec, unrelated_random_frames_stay_within_the_bound) {
  for (const double size : {1e-7, 1e-3, 1.0, 30.0}) {
    std::vector<Eigen::Matrix3Xd> frames;
    for (unsigned seed = 0; seed < 40; ++seed) frames.push_back(noise(12 * 4, size, seed));
    round_trip(parameters({12, 4}, bound_m, size), bound_m, frames);
  }
}

TEST(PositionCodec, grids_of_any_size_work) {
  for (const RibbonGrid grid : {RibbonGrid{2, 2}, {3, 2}, {2, 3}, {5, 9}, {2, 64}, {33, 17}}) {
    std::vector<Eigen::Matrix3Xd> frames;
    for (unsigned seed = 0; seed < 20; ++seed)
      frames.push_back(noise(grid.particle_count(), 1, seed));
    round_trip(parameters(grid, bound_m, 1), bound_m, frames);
  }
}

TEST(PositionCodec, a_bound_of_zero_keeps_every_bit_of_single_precision) {
  RoundTrip trip(parameters(sample_grid, 0, 1), 0);
  for (int frame = 0; frame < 20; ++frame)
    trip.take(sample_positions(frame).cast<float>().cast<double>());
  Eigen::Matrix3Xd odd = sample_positions(20).cast<float>().cast<double>();
  odd.col(0) << -0.0, 0x1p-149, -0x1p-133;
  odd.col(1) << 3.4028234663852886e38, -3.4028234663852886e38, 0.0;
  Eigen::Matrix3Xf decoded;
  trip.take(odd).frame.positions(decoded);
  EXPECT_TRUE(std::signbit(decoded(0, 0)));
  EXPECT_FALSE(std::signbit(decoded(2, 1)));
}

TEST(PositionCodec, numbers_half_of_all_numbers_away_from_their_prediction_come_back) {
  Eigen::Matrix3Xd positions = Eigen::Matrix3Xd::Zero(3, 16);
  positions(0, 0) = 1;
  // Its ordinal among all single-precision numbers is 2^31 below that of 1, which predicts it.
  positions(0, 2) = std::bit_cast<float>(0xC07FFFFFU);
  RoundTrip(parameters({4, 4}, 0, 1), 0).take(positions);
}

// Neighbours at opposite ends of what can be quantised: their differences need more bits than
// single precision has.
TEST(PositionCodec, numbers_at_both_ends_of_their_range_come_back) {
  constexpr float step_m = 0x1p-20F;
  std::vector<Eigen::Matrix3Xd> frames;
  for (unsigned seed = 0; seed < 3; ++seed) {
    Eigen::Matrix3Xd& positions = frames.emplace_back(noise(9 * 5, 0x1p-17, seed));
    int k = static_cast<int>(seed);
    for (double& coordinate : positions.reshaped())
      coordinate += (++k % 3 == 0 ? 16 : -16) * (1 - 0x1p-19);
  }
  for (const FrameEncoding encoding : round_trip({{9, 5}, step_m}, step_m / 2, frames))
    EXPECT_EQ(encoding, FrameEncoding::quantised);
}

TEST(PositionCodec, sudden_jumps_stay_within_the_bound) {
  std::vector<Eigen::Matrix3Xd> frames = sample_frames(20);
  for (std::size_t frame = 10; frame < 20; ++frame) frames[frame].array() += 25;
  for (std::size_t frame = 15; frame < 20; ++frame) frames[frame] *= -1;
  round_trip(parameters(sample_grid, bound_m, 30), bound_m, frames);
}

TEST(PositionCodec, a_ribbon_at_rest_costs_next_to_nothing) {
  RoundTrip trip(parameters({400, 16}, bound_m, 1), bound_m);
  const Eigen::Matrix3Xd rest = noise(6400, 1, 3);
  trip.take(rest);
  EXPECT_LT(trip.take(rest).geometry.size(), 250U);
}

// Near 100 m single precision has steps of 7.6e-6 m and rounds by up to 3.8e-6 m, near 1000 m by up
// to 3.1e-5 m, near 10 000 m by 4.9e-4 m.
TEST(PositionCodec, far_from_the_origin_rounding_counts_towards_the_bound) {
  std::vector<Eigen::Matrix3Xd> frames = sample_frames(5);
  for (Eigen::Matrix3Xd& frame : frames) frame.array() += 80;
  const CodecParameters codec = parameters(sample_grid, bound_m, 81);
  EXPECT_GT(codec.step_m, bound_m);
  EXPECT_LT(codec.step_m, 1.1 * bound_m);
  EXPECT_EQ(round_trip(codec, bound_m, frames)[0], FrameEncoding::quantised);
}

TEST(PositionCodec, frames_beyond_the_reach_of_quantised_positions_are_exact) {
  std::vector<Eigen::Matrix3Xd> frames = sample_frames(5);
  for (std::size_t frame = 1; frame < 3; ++frame) frames[frame].array() += 1000;
  const auto encodings = round_trip(parameters(sample_grid, 3.2e-5, 1), 3.2e-5, frames);
  ASSERT_EQ(encodings.size(), 5U);
  EXPECT_EQ(encodings[0], FrameEncoding::quantised);
  EXPECT_EQ(encodings[1], FrameEncoding::exact);
  EXPECT_EQ(encodings[2], FrameEncoding::exact);
  EXPECT_EQ(encodings[3], FrameEncoding::quantised);
}

TEST(PositionCodec, a_ribbon_is_expected_to_be_drawn_its_length_away_where_the_bound_allows) {
  EXPECT_EQ(quantisation_step_m(1e-5, 2, 4), quantisation_step_m(1e-5, 6));
  EXPECT_EQ(quantisation_step_m(4e-7, 6), 0);
  EXPECT_EQ(quantisation_step_m(4e-7, 2, 4), quantisation_step_m(4e-7, 3));
  EXPECT_GT(quantisation_step_m(4e-7, 2, 4), 0);
  EXPECT_EQ(quantisation_step_m(0, 2, 4), 0);
}

TEST(PositionCodec, where_rounding_uses_up_the_bound_positions_are_exact_single_precision) {
  EXPECT_EQ(quantisation_step_m(bound_m, 100), 0);
  EXPECT_EQ(quantisation_step_m(0, 1), 0);
  std::vector<Eigen::Matrix3Xd> frames = sample_frames(5);
  for (Eigen::Matrix3Xd& frame : frames) frame.array() += 100;
  round_trip(parameters(sample_grid, bound_m, 101), bound_m, frames);
}

TEST(PositionCodec, what_single_precision_cannot_hold_is_refused) {
  PositionEncoder encoder(parameters(sample_grid, bound_m, 1), bound_m);
  Eigen::Matrix3Xd positions = sample_positions(0);
  positions.array() += 10'000;
  EXPECT_THAT(refusal_of(encoder.encode(positions, nullptr)),
              HasSubstr("allow a larger position error"));
  positions.setConstant(1e300);
  EXPECT_FALSE(encoder.encode(positions, nullptr).has_value());
}

TEST(PositionCodec, a_position_that_is_not_finite_is_refused_by_name) {
  PositionEncoder encoder(parameters(sample_grid, bound_m, 1), bound_m);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Eigen::Matrix3Xd positions = sample_positions(1);
    positions(2, 6 * 17 + 4) = bad;
    EXPECT_THAT(refusal_of(encoder.encode(positions, nullptr)),
                HasSubstr("particle 17 along, 4 across"));
  }
}

// Decoders and encoders that have seen other frames before come to the same bits.
TEST(PositionCodec, what_was_coded_before_does_not_matter) {
  for (const RibbonGrid grid : {sample_grid, RibbonGrid{5, 9}, {2, 2}, {33, 17}}) {
    const CodecParameters codec = parameters(grid, bound_m, 1);
    PositionEncoder encoder(codec, bound_m);
    PositionDecoder decoder(codec);
    std::vector<EncodedFrame> frames;
    std::vector<const QuantisedFrame*> references;
    frames.reserve(12);
    for (unsigned seed = 0; seed < 12; ++seed) {
      references.push_back(seed < 2 ? nullptr : &frames[seed - 1].frame);
      frames.push_back(
          std::move(*encoder.encode(noise(grid.particle_count(), 1, seed), references.back())));
    }
    for (std::size_t k : {11U, 2U, 7U, 0U, 3U, 9U, 1U}) {
      QuantisedFrame decoded;
      ASSERT_TRUE(decoder.decode(frames[k].encoding, frames[k].geometry, references[k], decoded));
      Eigen::Matrix3Xf positions;
      Eigen::Matrix3Xf expected;
      decoded.positions(positions);
      frames[k].frame.positions(expected);
      EXPECT_EQ(positions, expected) << grid.along << " x " << grid.across << ", frame " << k;
      const auto again =
          PositionEncoder(codec, bound_m)
              .encode(noise(grid.particle_count(), 1, static_cast<unsigned>(k)), references[k]);
      EXPECT_EQ(again->geometry, frames[k].geometry);
    }
  }
}

// Damage that a checksum did not catch must not do harm: any bytes decode to something or are
// refused.
TEST(PositionCodec, damaged_geometry_does_no_harm) {
  const CodecParameters codec = parameters({5, 3}, bound_m, 1);
  RoundTrip trip(codec, bound_m);
  const EncodedFrame key = trip.take(noise(15, 1, 1));
  const EncodedFrame delta = trip.take(noise(15, 1, 2));
  PositionDecoder decoder(codec);
  QuantisedFrame decoded;
  Eigen::Matrix3Xf positions;
  for (const bool predicted : {false, true}) {
    const EncodedFrame& frame = predicted ? delta : key;
    const QuantisedFrame* reference = predicted ? &key.frame : nullptr;
    for (std::size_t at = 0; at < frame.geometry.size(); ++at) {
      for (int bit = 0; bit < 8; ++bit)
        if (decoder.decode(frame.encoding, flipped(frame.geometry, at, 1 << bit), reference,
                           decoded))
          decoded.positions(positions);
      ASSERT_FALSE(
          decoder.decode(frame.encoding, frame.geometry.substr(0, at), reference, decoded));
    }
  }
}

}  // namespace ribbon::position_codec_test

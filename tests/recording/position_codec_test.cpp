// Encoder and decoder of positions together.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "recording/position_decoder.h"
#include "recording/position_encoder.h"
#include "recording/sample_recording.h"

namespace ribbon {
namespace {

constexpr double bound_m = 1e-5;

double largest_error(const PositionDecoder& decoder, const Eigen::Matrix3Xd& truth) {
  Eigen::Matrix3Xf decoded;
  decoder.positions(decoded);
  EXPECT_EQ(decoded.cols(), truth.cols());
  return (decoded.cast<double>() - truth).cwiseAbs().maxCoeff();
}

// Encodes and decodes the frames; every coordinate must keep the bound. Returns their encodings.
std::vector<FrameEncoding> round_trip(const RibbonGrid& grid, double max_error_m,
                                      const std::vector<Eigen::Matrix3Xd>& frames) {
  PositionEncoder encoder(grid, max_error_m);
  PositionDecoder decoder(grid);
  std::vector<FrameEncoding> encodings;
  encodings.reserve(frames.size());
  for (const Eigen::Matrix3Xd& truth : frames) {
    const auto encoded = encoder.encode(truth);
    if (!encoded) {
      ADD_FAILURE() << encoded.error().sentence();
      break;
    }
    EXPECT_TRUE(decoder.decode(encoded->encoding, encoded->geometry));
    EXPECT_LE(largest_error(decoder, truth), max_error_m) << "frame " << encodings.size();
    encodings.push_back(encoded->encoding);
  }
  return encodings;
}

std::vector<Eigen::Matrix3Xd> sample_frames(int count) {
  std::vector<Eigen::Matrix3Xd> frames;
  frames.reserve(static_cast<std::size_t>(count));
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

TEST(PositionCodec, a_twisting_ribbon_stays_within_the_bound) {
  const auto encodings = round_trip(sample_header().grid, bound_m, sample_frames(70));
  ASSERT_EQ(encodings.size(), 70U);
  for (std::size_t frame = 0; frame < encodings.size(); ++frame)
    EXPECT_EQ(encodings[frame], frame % 32 == 0 ? FrameEncoding::key : FrameEncoding::delta);
}

TEST(PositionCodec, unrelated_random_frames_stay_within_the_bound) {
  for (const double size : {1e-7, 1e-3, 1.0, 30.0}) {
    std::vector<Eigen::Matrix3Xd> frames;
    for (unsigned seed = 0; seed < 40; ++seed) frames.push_back(noise(12 * 4, size, seed));
    EXPECT_EQ(round_trip({12, 4}, bound_m, frames).size(), 40U) << size;
  }
}

TEST(PositionCodec, the_smallest_grid_works) {
  std::vector<Eigen::Matrix3Xd> frames;
  for (unsigned seed = 0; seed < 40; ++seed) frames.push_back(noise(4, 1, seed));
  EXPECT_EQ(round_trip({2, 2}, bound_m, frames).size(), 40U);
}

TEST(PositionCodec, sudden_jumps_stay_within_the_bound) {
  std::vector<Eigen::Matrix3Xd> frames = sample_frames(20);
  for (std::size_t frame = 10; frame < 20; ++frame) frames[frame].array() += 25;
  for (std::size_t frame = 15; frame < 20; ++frame) frames[frame] *= -1;
  EXPECT_EQ(round_trip(sample_header().grid, bound_m, frames).size(), 20U);
}

TEST(PositionCodec, a_ribbon_at_rest_costs_next_to_nothing) {
  PositionEncoder encoder({400, 16}, bound_m);
  const Eigen::Matrix3Xd rest = noise(6400, 1, 3);
  ASSERT_TRUE(encoder.encode(rest).has_value());
  const auto second = encoder.encode(rest);
  ASSERT_TRUE(second.has_value());
  EXPECT_LT(second->geometry.size(), 100U);
}

// Near 100 m single precision has steps of 7.6e-6 m and rounds by up to 3.8e-6 m, near 1000 m by up
// to 3.1e-5 m, near 10 000 m by 4.9e-4 m.
TEST(PositionCodec, far_from_the_origin_rounding_counts_towards_the_bound) {
  std::vector<Eigen::Matrix3Xd> frames = sample_frames(5);
  for (Eigen::Matrix3Xd& frame : frames) frame.array() += 100;
  const auto encodings = round_trip(sample_header().grid, bound_m, frames);
  ASSERT_EQ(encodings.size(), 5U);
  EXPECT_EQ(encodings[0], FrameEncoding::key);
}

TEST(PositionCodec, where_rounding_uses_up_the_bound_frames_are_plain) {
  std::vector<Eigen::Matrix3Xd> frames = sample_frames(3);
  for (Eigen::Matrix3Xd& frame : frames) frame.array() += 1000;
  frames.push_back(sample_positions(3));
  frames.push_back(sample_positions(4));
  const auto encodings = round_trip(sample_header().grid, 3.2e-5, frames);
  ASSERT_EQ(encodings.size(), 5U);
  EXPECT_EQ(encodings[0], FrameEncoding::plain);
  EXPECT_EQ(encodings[2], FrameEncoding::plain);
  EXPECT_EQ(encodings[3], FrameEncoding::key) << "a plain frame is nothing to build upon";
  EXPECT_EQ(encodings[4], FrameEncoding::delta);
}

TEST(PositionCodec, a_ribbon_that_drifts_away_stays_within_the_bound) {
  std::vector<Eigen::Matrix3Xd> frames = sample_frames(30);
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    frames[frame].array() += 5.0 * static_cast<double>(frame);
  const auto encodings = round_trip(sample_header().grid, bound_m, frames);
  ASSERT_EQ(encodings.size(), 30U);
  EXPECT_GT(std::count(encodings.begin(), encodings.end(), FrameEncoding::key), 1)
      << "the step must become finer on the way";
}

TEST(PositionCodec, what_single_precision_cannot_hold_is_refused) {
  PositionEncoder encoder(sample_header().grid, bound_m);
  Eigen::Matrix3Xd positions = sample_positions(0);
  positions.array() += 10'000;
  const auto encoded = encoder.encode(positions);
  ASSERT_FALSE(encoded.has_value());
  EXPECT_NE(encoded.error().problem.find("max_position_error"), std::string::npos);
  positions.setConstant(1e300);
  EXPECT_FALSE(encoder.encode(positions).has_value());
}

TEST(PositionCodec, a_position_that_is_not_finite_is_refused_by_name) {
  PositionEncoder encoder(sample_header().grid, bound_m);
  ASSERT_TRUE(encoder.encode(sample_positions(0)).has_value());
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Eigen::Matrix3Xd positions = sample_positions(1);
    positions(2, 6 * 17 + 4) = bad;
    const auto encoded = encoder.encode(positions);
    ASSERT_FALSE(encoded.has_value());
    EXPECT_NE(encoded.error().problem.find("particle 17 along, 4 across"), std::string::npos);
  }
  const auto next = encoder.encode(sample_positions(1));
  ASSERT_TRUE(next.has_value());
  EXPECT_EQ(next->encoding, FrameEncoding::delta) << "as if the refused frames had not been";
}

TEST(PositionCodec, after_a_restart_a_frame_needs_no_other) {
  PositionEncoder encoder(sample_header().grid, bound_m);
  ASSERT_TRUE(encoder.encode(sample_positions(0)).has_value());
  encoder.restart();
  const auto encoded = encoder.encode(sample_positions(1));
  ASSERT_TRUE(encoded.has_value());
  PositionDecoder decoder(sample_header().grid);
  ASSERT_TRUE(decoder.decode(encoded->encoding, encoded->geometry));
  EXPECT_LE(largest_error(decoder, sample_positions(1)), bound_m);
}

TEST(PositionCodec, equal_frames_give_equal_bytes) {
  PositionEncoder first(sample_header().grid, bound_m);
  PositionEncoder second(sample_header().grid, bound_m);
  for (int frame = 0; frame < 5; ++frame)
    EXPECT_EQ(first.encode(sample_positions(frame))->geometry,
              second.encode(sample_positions(frame))->geometry);
}

TEST(PositionCodec, a_delta_frame_without_its_key_is_refused) {
  PositionEncoder encoder(sample_header().grid, bound_m);
  ASSERT_TRUE(encoder.encode(sample_positions(0)).has_value());
  const auto delta = encoder.encode(sample_positions(1));
  PositionDecoder decoder(sample_header().grid);
  EXPECT_FALSE(decoder.decode(delta->encoding, delta->geometry));
}

// Damage that a checksum did not catch must not do harm: any bytes decode to something or are
// refused.
TEST(PositionCodec, damaged_geometry_does_no_harm) {
  PositionEncoder encoder({5, 3}, bound_m);
  const auto key = encoder.encode(noise(15, 1, 1));
  const auto delta = encoder.encode(noise(15, 1, 2));
  PositionDecoder decoder({5, 3});
  Eigen::Matrix3Xf decoded;
  for (const auto* frame : {&*key, &*delta})
    for (std::size_t at = 0; at < frame->geometry.size(); ++at)
      for (int bit = 0; bit < 8; ++bit) {
        std::string damaged = frame->geometry;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
        ASSERT_TRUE(decoder.decode(key->encoding, key->geometry));
        if (decoder.decode(frame->encoding, damaged)) decoder.positions(decoded);
        ASSERT_FALSE(decoder.decode(frame->encoding, frame->geometry.substr(0, at)));
      }
}

}  // namespace
}  // namespace ribbon

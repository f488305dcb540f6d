#include "recording/position_codec.h"

#include <gtest/gtest.h>

#include "recording/sample_recording.h"

namespace ribbon {
namespace {

TEST(PositionCodec, decoded_positions_are_within_the_bound) {
  PositionEncoder encoder(sample_header().grid, 1e-5);
  PositionDecoder decoder(sample_header().grid);
  for (int frame = 0; frame < 70; ++frame) {
    const auto encoded = encoder.encode(sample_positions(frame));
    ASSERT_TRUE(encoded.has_value());
    ASSERT_TRUE(decoder.decode(encoded->encoding, encoded->geometry));
    Eigen::Matrix3Xf decoded;
    decoder.positions(decoded);
    EXPECT_LE((decoded.cast<double>() - sample_positions(frame)).cwiseAbs().maxCoeff(), 1e-5);
  }
}

}  // namespace
}  // namespace ribbon

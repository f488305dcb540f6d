// All instruction sets give the same bits.
#include "recording/codec/column_loops.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "parallel/instruction_set.h"
#include "recording/codec/position_decoder.h"
#include "recording/codec/position_encoder.h"
#include "recording/writer/recording_writer.h"

namespace ribbon::column_loops_test {

class InstructionSets : public testing::Test {
 protected:
  ~InstructionSets() override { choose_instruction_set(best_instruction_set()); }
};

// A wave on a ribbon, with noise of some steps: nothing is predicted exactly.
std::vector<Eigen::Matrix3Xd> restless_frames(const RibbonGrid& grid, int count) {
  std::mt19937 random(7);
  std::vector<Eigen::Matrix3Xd> frames;
  for (int frame = 0; frame < count; ++frame) {
    Eigen::Matrix3Xd& positions = frames.emplace_back(3, grid.particle_count());
    for (int p = 0; p < grid.particle_count(); ++p) {
      const double along = grid.row(p) / 40.0;
      positions.col(p) << along + 0.001 * frame, 0.2 * along * along - 0.002 * frame * along,
          0.01 * grid.column(p) + 0.0003 * frame * frame;
      for (double& coordinate : positions.col(p))
        coordinate += 5e-5 * (static_cast<double>(random()) / 4294967296.0 - 0.5);
    }
  }
  return frames;
}

struct Outcome {
  std::vector<std::string> geometry;
  std::vector<Eigen::Matrix3Xf> positions;
  bool operator==(const Outcome&) const = default;
};

// Every kind of prediction: from nothing, and from a frame that was itself predicted or not.
Outcome run(const RibbonGrid& grid, double step_m, double max_error_m) {
  const CodecParameters codec{grid, static_cast<float>(step_m)};
  PositionEncoder encoder(codec, max_error_m);
  PositionDecoder decoder(codec);
  auto frames = restless_frames(grid, 8);
  if (max_error_m == 0)
    for (auto& frame : frames) frame = frame.cast<float>().cast<double>().eval();
  std::vector<QuantisedFrame> decoded(frames.size());
  Outcome outcome;
  const auto take = [&](std::size_t frame, std::optional<std::size_t> before) {
    const QuantisedFrame* reference = before ? &decoded[*before] : nullptr;
    const auto encoded = encoder.encode(frames[frame], reference);
    ASSERT_TRUE(encoded.has_value()) << encoded.error().sentence();
    EXPECT_EQ(encoded->encoding,
              max_error_m == 0 ? FrameEncoding::exact : FrameEncoding::quantised);
    ASSERT_TRUE(decoder.decode(encoded->encoding, encoded->geometry, reference, decoded[frame]));
    Eigen::Matrix3Xf positions;
    decoded[frame].positions(positions);
    EXPECT_LE((positions.cast<double>() - frames[frame]).cwiseAbs().maxCoeff(), max_error_m);
    outcome.geometry.push_back(encoded->geometry);
    outcome.positions.push_back(positions);
  };
  take(0, {});
  take(1, 0);
  take(2, 1);
  take(3, 2);
  take(7, {});
  take(5, 7);
  return outcome;
}

TEST_F(InstructionSets, all_give_the_same_bits) {
  for (const RibbonGrid grid : {RibbonGrid{40, 16}, {33, 17}, {2, 2}, {9, 5}, {3, 70}})
    for (const bool uniform : {true, false}) {
      choose_instruction_set(InstructionSet::baseline);
      const double bound_m = uniform ? 1e-5 : 0;
      const double step_m = uniform ? static_cast<double>(quantisation_step_m(bound_m, 2)) : 0;
      const Outcome expected = run(grid, step_m, bound_m);
      for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
        if (!is_available(set)) continue;
        choose_instruction_set(set);
        EXPECT_TRUE(run(grid, step_m, bound_m) == expected)
            << grid.along << " x " << grid.across << (uniform ? "" : " in exact single precision");
      }
    }
}

}  // namespace ribbon::column_loops_test

// The same frames give the same bytes and the same bytes the same frames, whichever compiler,
// options and instructions: a recording is read alike everywhere.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "parallel/instruction_set.h"
#include "recording/codec/position_decoder.h"
#include "recording/codec/position_encoder.h"
#include "recording/writer/recording_writer.h"

namespace ribbon::same_bits_test {

// FNV-1a.
class Hash {
 public:
  template <class Number>
  void add(Number number) {
    value_ = (value_ ^ static_cast<std::uint64_t>(number)) * 0x100000001b3;
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

// Where a ribbon is bent, moved and shaken; made of sums, products and quotients alone, so that it
// is the same everywhere.
Eigen::Matrix3Xd positions_at(const RibbonGrid& grid, int frame) {
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  std::uint32_t random = 12345U + static_cast<std::uint32_t>(frame);
  for (int p = 0; p < grid.particle_count(); ++p) {
    random = random * 1664525U + 1013904223U;
    const double shaken = static_cast<double>(random) / 0x1p32 - 0.5;
    const double along = 0.01 * grid.row(p) + 0.002 * frame;
    const double bent = along * along / (1 + along);
    positions.col(p) << bent + 1e-6 * shaken, 0.006 * grid.column(p) * (1 + 0.1 * bent) - 0.2,
        along / (1 + bent * bent) + (frame > 5 ? 3e-5 : 0) * shaken;
  }
  return positions;
}

CodecParameters parameters_for(const RibbonGrid& grid, double max_error_m) {
  CodecParameters parameters;
  parameters.grid = grid;
  parameters.step_m = quantisation_step_m(max_error_m, 4);
  return parameters;
}

void add_frame(const EncodedFrame& encoded, const QuantisedFrame& decoded, Hash& hash) {
  hash.add(static_cast<std::uint32_t>(encoded.encoding));
  for (const char byte : encoded.geometry) hash.add(static_cast<unsigned char>(byte));
  Eigen::Matrix3Xf positions;
  decoded.positions(positions);
  for (const float coordinate : positions.reshaped())
    hash.add(std::bit_cast<std::uint32_t>(coordinate));
}

// What twelve frames become that are predicted from those before them.
void add_motion(const RibbonGrid& grid, double max_error_m, Hash& hash) {
  const CodecParameters parameters = parameters_for(grid, max_error_m);
  PositionEncoder encoder(parameters, max_error_m);
  PositionDecoder decoder(parameters);
  std::vector<QuantisedFrame> frames(12);
  for (std::uint32_t frame = 0; frame < frames.size(); ++frame) {
    const auto before = reference_of(frame);
    const QuantisedFrame* reference = before ? &frames[*before] : nullptr;
    const auto encoded =
        encoder.encode(positions_at(grid, static_cast<int>(frame)), reference).value();
    ASSERT_TRUE(decoder.decode(encoded.encoding, encoded.geometry, reference, frames[frame]));
    add_frame(encoded, frames[frame], hash);
    QuantisedFrame by_another;
    ASSERT_TRUE(PositionDecoder(parameters)
                    .decode(encoded.encoding, encoded.geometry, reference, by_another));
    Eigen::Matrix3Xf positions;
    Eigen::Matrix3Xf by_another_positions;
    frames[frame].positions(positions);
    by_another.positions(by_another_positions);
    ASSERT_EQ(by_another_positions, positions) << "a decoder must not remember other frames";
  }
}

std::uint64_t hash_of_motions() {
  Hash hash;
  for (const RibbonGrid grid :
       {RibbonGrid{40, 16}, RibbonGrid{33, 7}, RibbonGrid{9, 2}, RibbonGrid{2, 37}, {150, 3}})
    for (const double max_error_m : {1e-3, 1e-5, 1e-6, 0.0}) add_motion(grid, max_error_m, hash);
  return hash.value();
}

// Made by GCC 12 without sanitizers; the sanitizers' build is Clang's, with other optimisation.
// tests/same_bits.sh asks more builds.
constexpr std::uint64_t expected = 11140302071998707007U;

class SameBitsBy : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    if (!is_available(GetParam())) GTEST_SKIP() << "this processor does not have it";
    choose_instruction_set(GetParam());
  }
  void TearDown() override { choose_instruction_set(best_instruction_set()); }
};

TEST_P(SameBitsBy, every_build_and_processor) {
  EXPECT_EQ(hash_of_motions(), expected);
}

std::string name_of(const testing::TestParamInfo<InstructionSet>& set) {
  constexpr std::array names = {"baseline", "avx2", "avx512"};
  return names[static_cast<std::size_t>(set.param)];
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, SameBitsBy,
                         testing::Values(InstructionSet::baseline, InstructionSet::avx2,
                                         InstructionSet::avx512),
                         name_of);

}  // namespace ribbon::same_bits_test

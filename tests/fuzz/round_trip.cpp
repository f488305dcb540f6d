// Whatever the positions, the codec keeps its bound or refuses them.
#include <cmath>
#include <random>

#include "fuzz/fuzz_input.h"
#include "fuzz/must.h"
#include "recording/codec/position_decoder.h"
#include "recording/codec/position_encoder.h"

namespace ribbon {
namespace {

constexpr int most_frames = 6;

// The task of the codec, as the first bytes of the input have it.
struct Task {
  CodecParameters parameters;
  double bound_m;
};

Task take_task(FuzzInput& input) {
  constexpr std::array bounds_m = {0.0, 1e-300, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-2, 1.0, 1e30};
  constexpr std::array reaches_m = {1.0, 1e-6, 100.0, 1e30};
  const RibbonGrid grid{input.between(2, 40), input.between(2, 19)};
  const double bound_m = bounds_m[input.between(0, static_cast<int>(bounds_m.size()) - 1)];
  const double reach_m = reaches_m[input.between(0, static_cast<int>(reaches_m.size()) - 1)];
  Task task{{}, bound_m};
  task.parameters.grid = grid;
  task.parameters.step_m = quantisation_step_m(bound_m, reach_m);
  return task;
}

// Frames of all kinds: smooth, moved a bit, noisy, and with single coordinates of any bits.
class Motion {
 public:
  explicit Motion(const RibbonGrid& grid)
      : grid_(grid), positions_(Eigen::Matrix3Xd::Zero(3, grid.particle_count())) {}

  const Eigen::Matrix3Xd& next(FuzzInput& input) {
    const int changes = input.between(0, 255);
    if ((changes & 1) != 0) bend(input);
    if ((changes & 2) != 0) positions_.array() += input.take<float>();
    if ((changes & 4) != 0) positions_ *= std::ldexp(1.0, input.between(0, 40) - 20);
    if ((changes & 8) != 0) shake(input);
    if ((changes & 16) != 0) set_some(input);
    if ((changes & 32) != 0) positions_.array() *= input.take<double>();
    return positions_;
  }

 private:
  void bend(FuzzInput& input) {
    const double pitch = 0.01 * input.take<std::uint8_t>();
    for (int p = 0; p < grid_.particle_count(); ++p)
      positions_.col(p) += Eigen::Vector3d(std::cos(pitch * grid_.row(p)),
                                           std::sin(pitch * grid_.row(p)), 0.01 * grid_.column(p));
  }

  void shake(FuzzInput& input) {
    std::mt19937 random(input.take<std::uint8_t>());
    const double size = std::ldexp(1.0, -input.between(0, 40));
    for (double& coordinate : positions_.reshaped())
      coordinate += size * (static_cast<double>(random()) / 0x1p32 - 0.5);
  }

  void set_some(FuzzInput& input) {
    for (int i = input.between(0, 7); i >= 0; --i)
      positions_.reshaped()(input.take<std::uint16_t>() % positions_.size()) = input.take<double>();
  }

  RibbonGrid grid_;
  Eigen::Matrix3Xd positions_;
};

// None, or one of the frames.
const QuantisedFrame* take_reference(const std::vector<QuantisedFrame>& frames, FuzzInput& input) {
  const int number = input.between(0, static_cast<int>(frames.size()));
  return number == 0 ? nullptr : &frames[number - 1];
}

void check_bound(const Eigen::Matrix3Xf& decoded, const Eigen::Matrix3Xd& positions,
                 double bound_m) {
  if (bound_m == 0)
    must(same_bits(decoded, positions.cast<float>()), "with bound 0 the floats are the same");
  else
    must((decoded.cast<double>() - positions).cwiseAbs().maxCoeff() <= bound_m,
         "the bound is kept");
}

// A frame through the codec; what a decoder has of it is added to `frames`.
void check_frame(const Task& task, const Eigen::Matrix3Xd& positions, PositionEncoder& encoder,
                 PositionDecoder& decoder, FuzzInput& input, std::vector<QuantisedFrame>& frames) {
  const QuantisedFrame* reference = take_reference(frames, input);
  const auto encoded = encoder.encode(positions, reference);
  const auto again = PositionEncoder(task.parameters, task.bound_m).encode(positions, reference);
  must(encoded.has_value() == again.has_value(), "another encoder accepts the same frames");
  must(positions.allFinite() || !encoded, "what is no number is refused");
  if (!encoded) return;
  must(encoded->encoding == again->encoding && encoded->geometry == again->geometry,
       "the same frame gives the same bytes");
  const ExactCopy geometry(encoded->geometry);
  QuantisedFrame decoded;
  must(decoder.decode(encoded->encoding, geometry.view(), reference, decoded),
       "what was encoded can be decoded");
  Eigen::Matrix3Xf ours;
  Eigen::Matrix3Xf theirs;
  decoded.positions(ours);
  encoded->frame.positions(theirs);
  must(same_bits(ours, theirs), "the encoder knows what a decoder will have");
  check_bound(ours, positions, task.bound_m);
  frames.push_back(std::move(decoded));
}

}  // namespace
}  // namespace ribbon

// libFuzzer gives the name. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ribbon;
  FuzzInput input(data, size);
  const Task task = take_task(input);
  PositionEncoder encoder(task.parameters, task.bound_m);
  PositionDecoder decoder(task.parameters);
  Motion motion(task.parameters.grid);
  std::vector<QuantisedFrame> frames;
  frames.reserve(most_frames);  // references point into it
  for (int i = 0; i < most_frames && !input.rest().empty(); ++i)
    check_frame(task, motion.next(input), encoder, decoder, input, frames);
  return 0;
}
